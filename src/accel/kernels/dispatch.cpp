#include "accel/kernels/dispatch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <cstdlib>
#include <string>

#include "accel/kernels/targets.h"

namespace dapple {
namespace {

const KernelTable* find(std::string_view isa) {
  for (const KernelTable* table : kernel_tables()) {
    if (table->isa == isa) return table;
  }
  return nullptr;
}

std::string_view isa_from_environment() {
  const char* isa = std::getenv("DAPPLE_ISA");
  return isa == nullptr ? "" : isa;
}

const KernelTable* choose_at_start() {
  const KernelTable* named = find(isa_from_environment());
  return named != nullptr ? named : kernel_tables().front();
}

std::atomic<const KernelTable*>& chosen() {
  static std::atomic<const KernelTable*> table{choose_at_start()};
  return table;
}

tl::unexpected<Error> unknown_isa(std::string_view isa, std::string place) {
  return fail(Errc::usage, std::move(place),
              fmt::format("this processor has no level '{}'; it has {}", isa,
                          fmt::join(available_isas(), ", ")));
}

}  // namespace

LeafKinds leaf_kinds(const SceneView& scene) {
  const std::size_t all = scene.object_count();
  if (scene.object_count(ShapeKind::sphere) == all) return LeafKinds::spheres;
  return scene.object_count(ShapeKind::triangle) == all ? LeafKinds::triangles : LeafKinds::any;
}

const KernelTable& kernels() { return *chosen().load(std::memory_order_relaxed); }

std::vector<std::string_view> available_isas() {
  std::vector<std::string_view> isas;
  for (const KernelTable* table : kernel_tables()) isas.push_back(table->isa);
  return isas;
}

Status force_isa(std::string_view isa) {
  const KernelTable* table = find(isa);
  if (table == nullptr) return unknown_isa(isa, "");
  chosen() = table;
  return {};
}

Status check_isa_override() {
  const std::string_view isa = isa_from_environment();
  if (isa.empty() || find(isa) != nullptr) return {};
  return unknown_isa(isa, "DAPPLE_ISA");
}

}  // namespace dapple

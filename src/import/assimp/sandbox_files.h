// What assimp sees of the file system: the folder of the imported file, to read.
#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "import/sandbox.h"

namespace dapple::assimp {

class SandboxFiles final : public Assimp::IOSystem {
 public:
  explicit SandboxFiles(const Sandbox& sandbox) : sandbox_(sandbox) {}

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  const Sandbox& sandbox_;
};

}  // namespace dapple::assimp

// Working memory that threads borrow and give back.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace dapple {

template <class T>
class IdlePool {
 public:
  // A T that nobody else uses; a new one if there is none.
  std::unique_ptr<T> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<T>();
    auto item = std::move(idle_.back());
    idle_.pop_back();
    return item;
  }
  void give_back(std::unique_ptr<T> item) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(item));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace dapple

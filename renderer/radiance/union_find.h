#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace lightbench {

/// Which of `count` things are connected: sets that grow together.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// One of the things of i's set, the same for all of them until it is joined with another.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace lightbench

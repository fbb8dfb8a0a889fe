#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

namespace lightbench {

/// A table of names in the order of their first use.
class NameTable {
 public:
  std::int32_t index_of(std::string_view name) {
    if (const auto found = indices_.find(name); found != indices_.end()) return found->second;
    const auto index = std::int32_t(names_.size());
    indices_.emplace(names_.emplace_back(name), index);
    return index;
  }
  const std::deque<std::string>& names() const { return names_; }

 private:
  std::deque<std::string> names_;  // which stay where they are
  std::unordered_map<std::string_view, std::int32_t> indices_;
};

}  // namespace lightbench

#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace plumb {

/// Numbers distinct values (lists of integers) in the order in which they are first seen.
class ValueNumbering {
 public:
  struct Result {
    std::int32_t number;
    bool is_new;
  };
  Result number(const std::vector<std::int64_t>& value) {
    const auto [place, is_new] = numbers_.try_emplace(value, static_cast<std::int32_t>(numbers_.size()));
    return {place->second, is_new};
  }

 private:
  struct Hash {
    std::size_t operator()(const std::vector<std::int64_t>& value) const {
      std::uint64_t sum = value.size();
      for (const std::int64_t v : value) {
        sum ^= static_cast<std::uint64_t>(v) * 0x9e3779b97f4a7c15u;
        sum = ((sum << 27) | (sum >> 37)) * 0xbf58476d1ce4e5b9u;
      }
      return sum ^ (sum >> 31);
    }
  };
  std::unordered_map<std::vector<std::int64_t>, std::int32_t, Hash> numbers_;
};

}  // namespace plumb

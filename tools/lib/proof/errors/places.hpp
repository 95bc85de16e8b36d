// The places of search.cpp: drawn at random, and beside another one.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "search.hpp"

using Place = std::array<std::uint32_t, kInputs>;

enum class Kind { any, word, number, fraction, position, beside };
struct Input {
  Kind kind = Kind::any;
  double lo = 0.0, hi = 0.0;
  bool is_float() const { return kind != Kind::any && kind != Kind::word; }
  bool moves() const { return kind == Kind::any || (kind != Kind::beside && lo < hi); }
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint32_t word() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const std::uint64_t x = (state_ ^ state_ >> 33u) * 0xff51afd7ed558ccdu;
    return static_cast<std::uint32_t>(x >> 32u);
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(std::uint64_t{word()} * n >> 32u); }
  double unit() { return word() * 0x1p-32; }
  double in(double lo, double hi) { return lo + (hi - lo) * unit(); }

 private:
  std::uint64_t state_;
};

inline std::uint32_t bits_of(double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); }
inline double number_of(std::uint32_t word) { return static_cast<double>(std::bit_cast<float>(word)); }

class Places {
 public:
  Places(std::vector<Input> inputs, Random& random) : inputs_(std::move(inputs)), random_(random) {}

  std::size_t size() const { return inputs_.size(); }
  const Input& operator[](std::size_t i) const { return inputs_[i]; }

  Place drawn() {
    Place place{};
    for (std::size_t i = 0; i < inputs_.size(); ++i) place[i] = random_word(inputs_[i]);
    return complete(place);
  }
  // A place beside it, or with other words.
  Place moved(const Place& from, bool words) {
    Place place = from;
    for (bool has_moved = false; !has_moved;) {
      bool any = false;
      for (std::size_t i = 0; i < inputs_.size(); ++i) {
        const Input& input = inputs_[i];
        if (!input.moves() || input.is_float() == words) continue;
        any = true;
        if (random_.below(2) != 0 && has_moved) continue;
        has_moved = true;
        if (words) {
          place[i] = random_word(input);
        } else {
          const double old = number_of(from[i]);
          const double by =
              std::max(0.05, std::fabs(old)) * std::ldexp(random_.unit() - 0.5, -static_cast<int>(random_.below(24)));
          place[i] = bits_of(std::clamp(old + by, input.lo, input.hi));
        }
      }
      if (!any) break;
    }
    return complete(place);
  }

  Place complete(Place place) const {
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (inputs_[i].kind != Kind::beside) continue;
      const double other = number_of(place[static_cast<std::size_t>(inputs_[i].lo)]), length = inputs_[i].hi;
      place[i] = bits_of(std::sqrt(std::max(length * length - other * other, 0.0)));
    }
    return place;
  }

  Place between(const Place& from, const Place& to) const {
    Place middle = from;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (inputs_[i].is_float()) middle[i] = bits_of((number_of(from[i]) + number_of(to[i])) / 2.0);
    }
    return middle;
  }

 private:
  std::uint32_t random_word(const Input& input) {
    switch (input.kind) {
      case Kind::any:
        return random_.word();
      case Kind::word:
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(random_.in(input.lo, input.hi + 1.0))));
      case Kind::number: {
        const std::uint32_t at = random_.below(8);
        return bits_of(at == 0 ? input.lo : at == 1 ? input.hi : random_.in(input.lo, input.hi));
      }
      case Kind::fraction:
        switch (random_.below(8)) {
          case 0:
            return bits_of(std::ldexp(random_.unit(), -static_cast<int>(random_.below(24))));
          case 1:
            return bits_of(std::min(1.0 - std::ldexp(random_.unit(), -static_cast<int>(random_.below(24))), input.hi));
          case 2:
            return bits_of(0.5 + std::ldexp(random_.unit() - 0.5, -static_cast<int>(random_.below(20))));
          default:
            return bits_of(std::min(random_.unit(), input.hi));
        }
      case Kind::beside:
        return 0;  // complete() makes it
      case Kind::position:
        break;
    }
    const double size = std::ldexp(input.hi, -static_cast<int>(random_.below(2) * random_.below(12)));
    return bits_of(std::clamp(random_.in(-size, size), input.lo, input.hi));
  }

  std::vector<Input> inputs_;
  Random& random_;
};

inline std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

inline Input input_of(const std::string& text) {
  const std::map<std::string_view, Kind> kinds = {{"any", Kind::any},           {"word", Kind::word},
                                                  {"float", Kind::number},      {"fraction", Kind::fraction},
                                                  {"position", Kind::position}, {"beside", Kind::beside}};
  const std::vector<std::string> parts = parts_of(text);
  if (parts.size() == 1) return {kinds.at(parts[0])};
  return {kinds.at(parts[0]), std::stod(parts.at(1)), std::stod(parts.at(2))};
}

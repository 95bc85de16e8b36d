#include "run/failures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <unordered_map>

#include "cases/facets.hpp"

namespace hn {
namespace {

// More values than these name nothing that is common.
constexpr std::size_t kMostCommon = 2;
// More of those that passed are called the others.
constexpr std::size_t kMostNamed = 3;
// A trait of nearly all passed cases explains little: it must leave out one in so many of them.
constexpr std::size_t kSeparatedOfAll = 20;
constexpr std::size_t kToldOfGroup = 4;

enum class End { failed, passed, warned, excused };

std::optional<End> end_of(const CaseResult& result) {
  const Status status = result.outcome.status;
  if (status == Status::unsupported) return std::nullopt;  // it did not run
  if (!is_bad(status)) return status == Status::pass ? End::passed : End::warned;
  return result.excuse.empty() ? End::failed : End::excused;
}

// A case that ran, with the numbers of the texts of its facets; 0 is the empty text.
struct Row {
  const CaseResult* result;
  End end;
  std::array<std::size_t, kFacets> values;
};

using Rows = std::vector<const Row*>;
using Values = std::set<std::size_t>;

class Texts {
 public:
  std::size_t number_of(const std::string& text) {
    const auto [entry, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return entry->second;
  }

  const std::string& operator[](std::size_t number) const { return texts_[number]; }

  std::string listed(const Values& values) const {
    std::vector<std::string_view> list;
    for (const std::size_t value : values) list.push_back(texts_[value]);
    std::sort(list.begin(), list.end());
    const std::string_view last = list.back();
    list.pop_back();
    return list.empty() ? std::string(last) : fmt::format("{} or {}", fmt::join(list, ", "), last);
  }

 private:
  std::unordered_map<std::string, std::size_t> numbers_ = {{"", 0}};
  std::vector<std::string> texts_ = {""};
};

Values values_in(const Rows& rows, std::size_t facet) {
  Values values;
  for (const Row* row : rows) values.insert(row->values[facet]);
  return values;
}

// A common trait of the failed cases in a facet: they have one of few values, or all but one.
struct Trait {
  std::size_t facet;
  bool by_absence;  // values are what none of them has
  Values values;

  bool has(const Row& row) const { return values.contains(row.values[facet]) != by_absence; }
};

std::optional<Trait> trait_of(std::size_t facet, const Rows& failed, const Rows& others) {
  const Values bad = values_in(failed, facet);
  if (bad.contains(0)) return std::nullopt;
  Values good = values_in(others, facet);
  good.erase(0);
  for (const std::size_t value : bad) good.erase(value);
  if (good.empty()) return std::nullopt;
  if (bad.size() <= kMostCommon) return Trait{facet, false, bad};
  if (good.size() == 1) return Trait{facet, true, good};
  return std::nullopt;
}

std::size_t separated_by(const Trait& trait, const Rows& others) {
  return static_cast<std::size_t>(
      std::count_if(others.begin(), others.end(), [&](const Row* row) { return !trait.has(*row); }));
}

// The traits that together separate the failed cases from most of the others; each is weighed by the cases that are
// left. One value is simpler than two, which must separate more than twice as many.
std::vector<Trait> traits_of(const Rows& failed, Rows others, std::size_t share) {
  std::vector<Trait> chosen;
  while (failed.size() > 1 && !others.empty()) {
    std::optional<Trait> best;
    double best_score = 0.0;
    for (std::size_t facet = 0; facet < kFacets; ++facet) {
      auto trait = trait_of(facet, failed, others);
      const std::size_t separated = trait ? separated_by(*trait, others) : 0;
      if (separated <= others.size() / share) continue;
      const double score = static_cast<double>(separated) / static_cast<double>(trait->values.size());
      if (score <= best_score) continue;
      best_score = score;
      best = std::move(trait);
    }
    if (!best) break;
    std::erase_if(others, [&](const Row* row) { return !best->has(*row); });
    chosen.push_back(std::move(*best));
  }
  return chosen;
}

// "all 1311 in 3D pass": of cases that did not fail unless that is excused.
std::string success_of(const Rows& rows, std::string_view which, std::string_view one) {
  const auto count = [&](End end) {
    return std::count_if(rows.begin(), rows.end(), [&](const Row* row) { return row->end == end; });
  };
  const auto excused = count(End::excused);
  const auto good = static_cast<std::ptrdiff_t>(rows.size()) - excused;
  if (excused != 0) {
    return fmt::format("none of the {} {} fails, apart from {} that {} excused", rows.size(), which, excused,
                       excused == 1 ? "is" : "are");
  }
  if (count(End::warned) != 0) return fmt::format("none of the {} {} fails", good, which);
  return good == 1 ? fmt::format("the {} passes", one) : fmt::format("all {} {} pass", good, which);
}

// The places in Facets of what the layers are known by.
constexpr std::size_t kKind = 0;
constexpr std::size_t kDimension = 1;
constexpr std::size_t kPeriod = 5;
constexpr std::size_t kFunction = 9;
constexpr std::size_t kCheck = 10;
constexpr std::array kOfFunctions = {kKind, kDimension, kPeriod, kFunction};

// It counts all others, so that it is true whatever the other lines are.
std::string sentence_of(const Trait& trait, const Rows& failed, const Rows& others, const Texts& texts) {
  Rows apart;
  for (const Row* row : others) {
    if (!trait.has(*row)) apart.push_back(row);
  }
  const auto is_of_failed = [&](const Row* row) {
    return std::ranges::count(failed, row->values[kFunction], [](const Row* one) { return one->values[kFunction]; });
  };
  // A trait of functions themselves is that of other functions elsewhere.
  const bool by_function = std::ranges::count(kOfFunctions, trait.facet) != 0;
  const std::string_view whose = by_function || std::ranges::any_of(apart, is_of_failed) ? "" : " (of other functions)";
  if (trait.by_absence) {
    return fmt::format("No failing case is {}; {}{}.", texts.listed(trait.values),
                       success_of(apart, "such cases", "one such case"), whose);
  }
  Values good = values_in(apart, trait.facet);
  good.erase(0);
  std::string which = "others";
  std::string one = "other one";
  if (good.size() <= kMostNamed) {
    std::erase_if(apart, [&](const Row* row) { return row->values[trait.facet] == 0; });
    which = texts.listed(good);
    one = "one " + which;
  }
  return fmt::format("Every failing case is {}; {}{}.", texts.listed(trait.values), success_of(apart, which, one),
                     whose);
}

// Each layer is made of those before it. Files as a whole and settings are in none.
enum class Layer { driver, hashes, gradients, noises, sums };

std::optional<Layer> layer_of(std::string_view kind) {
  if (kind == "of what drivers are known to get wrong") return Layer::driver;
  if (kind == "of hashes") return Layer::hashes;
  if (kind == "of gradients" || kind == "of positions") return Layer::gradients;
  if (kind == "of octave sums") return Layer::sums;
  return kind.ends_with(" noise") ? std::optional(Layer::noises) : std::nullopt;
}

std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

class Sorter {
 public:
  explicit Sorter(const Run& run) {
    for (const CaseResult& result : run.cases) {
      const auto end = end_of(result);
      if (!end) continue;
      Row row{&result, *end, {}};
      const Facets facets = facets_of(result.id);
      for (std::size_t i = 0; i < kFacets; ++i) row.values[i] = texts_.number_of(facets[i]);
      rows_.push_back(row);
    }
    for (const Row& row : rows_) {
      if (row.end == End::failed) failed_.push_back(&row);
      ++ran_[function_of(row.result->id)];
    }
    const Values failing_checks = values_in(failed_, kCheck);
    for (const Row& row : rows_) {
      const std::size_t check = row.values[kCheck];
      if (row.end != End::failed && (check == 0 || failing_checks.contains(check))) others_.push_back(&row);
    }
  }

  Failures sorted() const {
    Failures failures{.failed = failed_.size(), .ran = rows_.size(), .common = {}, .groups = {}};
    const std::vector<Trait> traits = traits_of(failed_, others_, kSeparatedOfAll);
    const Rows lowest = lowest_layer();
    if (auto sentence = beginning(lowest); !sentence.empty()) failures.common.push_back(std::move(sentence));
    for (const Trait& trait : traits) failures.common.push_back(sentence_of(trait, failed_, others_, texts_));
    for (const Rows& rows : grouped()) failures.groups.push_back(group_of(rows, traits));
    std::stable_partition(failures.groups.begin(), failures.groups.end(), [&](const FailureGroup& group) {
      return std::ranges::any_of(lowest, [&](const Row* row) { return function_of(row->result->id) == group.title; });
    });
    // A single group shows the common trait of its cases itself.
    if (failed_.size() > 1 && failures.common.empty() && (others_.empty() || failures.groups.size() > 1)) {
      failures.common.push_back(nothing_in_common());
    }
    return failures;
  }

 private:
  static bool has_values(const CaseResult& result) {
    return result.outcome.status == Status::fail && result.outcome.mismatches != 0;
  }

  std::string nothing_in_common() const {
    if (!others_.empty()) return "The names of the failing cases have nothing in common.";
    const std::size_t passed = rows_.size() - failed_.size();
    if (passed == 0) return "Every case that ran fails.";
    return fmt::format("Every case that compares with right values fails; the {} the driver with itself.",
                       passed == 1 ? "one that passes compares" : fmt::format("{} that pass compare", passed));
  }

  std::optional<Layer> layer_in(const Row& row) const { return layer_of(texts_[row.values[kKind]]); }

  // The cases with wrong values in the lowest layer that has any.
  Rows lowest_layer() const {
    Rows lowest;
    for (const Row* row : failed_) {
      const auto layer = layer_in(*row);
      if (!layer || !has_values(*row->result) || (*layer != Layer::driver && row->values[kCheck] != 0)) continue;
      if (!lowest.empty() && layer < layer_in(*lowest.front())) lowest.clear();
      if (lowest.empty() || layer == layer_in(*lowest.front())) lowest.push_back(row);
    }
    return lowest;
  }

  // Where to begin; nothing unless most of the other failures are of what is made of this layer.
  std::string beginning(const Rows& lowest) const {
    if (lowest.empty()) return {};
    const auto layer = layer_in(*lowest.front());
    Rows others = failed_;
    std::erase_if(others, [&](const Row* row) { return layer_in(*row) == layer; });
    const Values dimensions = values_in(lowest, kDimension);
    const bool of_any = layer == Layer::driver || dimensions.contains(0);
    const auto above = std::ranges::count_if(others, [&](const Row* row) {
      return layer_in(*row) && (of_any || dimensions.contains(row->values[kDimension]));
    });
    if (2 * above <= std::ssize(others)) return {};
    std::vector<std::string_view> names;
    for (const Row* row : lowest) {
      const auto name = function_of(row->result->id);
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    const auto shown = std::span(names).first(std::min(names.size(), kMostNamed));
    const std::string more =
        shown.size() < names.size() ? fmt::format(" and {} more", names.size() - shown.size()) : "";
    return fmt::format("Begin with {}{}, {}: {} of {} other failures may follow.", fmt::join(shown, ", "), more,
                       layer == Layer::driver ? "a few lines without the library" : "the lowest layer that fails",
                       above, others.size());
  }

  std::vector<Rows> grouped() const {
    std::vector<Rows> groups;
    std::map<std::string, std::size_t> places;
    for (const Row* row : failed_) {
      const CaseResult& result = *row->result;
      const std::string key = has_values(result)
                                  ? std::string(function_of(result.id))
                                  : fmt::format("{}\n{}", name_of(result.outcome.status), result.outcome.message);
      const auto [place, is_new] = places.try_emplace(key, groups.size());
      if (is_new) groups.emplace_back();
      groups[place->second].push_back(row);
    }
    return groups;
  }

  FailureGroup group_of(const Rows& rows, const std::vector<Trait>& of_all) const {
    const CaseResult& first = *rows.front()->result;
    FailureGroup group{.status = first.outcome.status, .title = {}, .ran = 0, .only = {}, .cases = {}};
    for (const Row* row : rows) group.cases.push_back(row->result);
    // Held against those that have what all that failed has: the rest is printed already.
    Rows others;
    if (has_values(first)) {
      group.title = function_of(first.id);
      group.ran = ran_.at(group.title);
      std::ranges::copy_if(others_, std::back_inserter(others),
                           [&](const Row* row) { return function_of(row->result->id) == group.title; });
    } else {
      group.title = first_line(first.outcome.message);
      others = others_;
    }
    std::erase_if(others, [&](const Row* row) {
      return !std::all_of(of_all.begin(), of_all.end(), [&](const Trait& trait) { return trait.has(*row); });
    });
    for (const Trait& trait : traits_of(rows, others, kToldOfGroup)) {
      group.only += fmt::format("{}{} {}", group.only.empty() ? "" : ", ", trait.by_absence ? "never" : "only",
                                texts_.listed(trait.values));
    }
    return group;
  }

  Texts texts_;
  std::vector<Row> rows_;
  Rows failed_;
  Rows others_;
  std::map<std::string_view, std::size_t> ran_;  // by function
};

}  // namespace

std::string FailureGroup::text() const {
  const std::string_view noun = (of_function() ? ran : cases.size()) == 1 ? "case" : "cases";
  const std::string what = of_function() ? fmt::format("{} of {} {} of {}", cases.size(), ran, noun, title)
                                         : fmt::format("{} {}: {}", cases.size(), noun, title);
  return only.empty() ? what : fmt::format("{} ({})", what, only);
}

Failures failures_of(const Run& run) { return Sorter(run).sorted(); }

}  // namespace hn

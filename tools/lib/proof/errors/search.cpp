// Searches for the largest error of a function: Monte Carlo arithmetic, and a climb.
//
//   search FUNCTION SEED EFFORT INPUT ... / GROUP ...
//
//   FUNCTION   its number in rounded.inc
//   EFFORT     how many runs of 16 lanes; half of them at random places
//   INPUT      any                  a word
//              word:LO:HI           an integer
//              float:LO:HI          a number; LO and HI are drawn often
//              fraction:LO:HI       in [0, 1], often near 0, 1/2 or 1
//              position:LO:HI       of any size
//              beside:I:LENGTH      such that it and input I are a vector of that length
//              jumps                no input: the search goes to where the exact values jump, too
//   GROUP      for each output NUMBER:JUMP:BY; outputs with a number have an error in common. Where one of them is off
//   by
//              more than JUMP, all of them jump, which is no error. BY is "one", or by what it is multiplied:
//              "output:I", "input:I", or "inverse:I" of an input
//
// It prints for each group, in the order of their numbers: the error; that of the random places alone; the least and
// the greatest exact value; the words of the place; then, in the last line, how many operations round, and how many
// roots and divisors the text has.
//
// First random places, each with 16 random roundings. Then walks to where a root is of 0 or a divisor is 0: there a
// small error becomes a large one, and random places come near too rarely. From the worst places a climb: over the
// roundings of each operation (a flip in each lane; all that gain are taken, or the best part of them), and over places
// beside it.
#include <cstdio>
#include <cstdlib>

#include "places.hpp"

namespace {

using hn::roundings::kLanes;
constexpr std::uint32_t kPool = 1u << 16u;
constexpr int kExact = 4;  // a mode of rounded.cpp

enum class By { one, output, input, inverse };
struct Output {
  std::size_t group = 0;
  double jump = HUGE_VAL;
  By by = By::one;
  std::size_t of = 0;  // its number
};

class Search {
 public:
  Search(int function, std::uint64_t seed, long effort, std::vector<Input> inputs, std::vector<Output> outputs)
      : function_(function),
        random_(seed),
        effort_(effort),
        places_(std::move(inputs), random_),
        outputs_(std::move(outputs)),
        pool_(kLanes * (kPool + kOperations)),
        base_(kLanes * kOperations),
        tried_(base_) {
    for (std::uint32_t& way : pool_) way = random_.word() & kFlips;
    for (const Output& output : outputs_) groups_.resize(std::max(groups_.size(), output.group + 1));
  }

  void run() {
    for (long i = 0; i < effort_ / 2; ++i) {
      const Place place = places_.drawn();
      try_ways_of_pool(place, random_.below(kPool));
      watch(place);
    }
    for (Group& group : groups_) group.random = group.found.empty() ? 0.0 : group.found.front().error;
    walk();
    if (jumps_) cross();
    for (std::size_t group = 0; group < groups_.size(); ++group) climb_in(group);
  }

  void take_jumps() { jumps_ = true; }

  void print() const {
    for (const Group& group : groups_) {
      std::printf("%.9g %.9g %.9g %.9g", group.error, group.random, group.least, group.greatest);
      for (std::size_t i = 0; i < places_.size(); ++i) std::printf(" %u", group.place[i]);
      std::printf("\n");
    }
    std::printf("%u %zu\n", operations_, nearest_.size());
  }

 private:
  static constexpr std::uint32_t kUp = 0x80000000u, kFused = 1u, kFlips = kUp | kFused;
  static constexpr std::size_t kStarts = 32;
  static constexpr long kSteps = 24;  // of a walk from a random place
  struct Start {
    double error = 0.0;
    Place place{};
    std::size_t output = 0;
    std::vector<std::uint32_t> ways;  // of one lane
  };
  struct Group {
    double error = 0.0, random = 0.0, least = HUGE_VAL, greatest = -HUGE_VAL;
    Place place{};
    std::vector<Start> found;  // the worst first, one for each place
  };
  struct Near {
    double operand = HUGE_VAL;
    Place place{};
  };

  // --- Runs ---

  void exactly(const Place& place, std::array<double, kOutputs>& exact) {
    std::array<double, kInputs> numbers{};
    Place words = place;
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      if (places_[i].is_float()) numbers[i] = number_of(place[i]), words[i] = i;
    }
    std::array<std::uint32_t, kOutputs> unused{};
    singular.clear();
    evaluate(function_, kExact, 0, 0.0, 1, words.data(), numbers.data(), unused.data(), exact.data());
  }
  void run_at(const Place& place, const std::uint32_t* ways) {
    for (std::size_t i = 0; i < kInputs; ++i) words_[i].fill(place[i]);
    operations_ = std::max(operations_, std::min(run_lanes(function_, ways, words_, results_), kOperations));
  }
  double error_of(std::size_t output, std::uint32_t lane, const std::array<double, kOutputs>& exact) const {
    const Output& of = outputs_[output];
    // The root of a number below 0 is none. Where both are infinite there is no error.
    if (jumps_ && std::isnan(number_of(results_[output][lane])) && !std::isnan(exact[output])) return HUGE_VAL;
    for (std::size_t other = 0; other < outputs_.size(); ++other) {
      const double off = std::fabs(number_of(results_[other][lane]) - exact[other]);
      if (outputs_[other].group == of.group && !(off <= of.jump)) return 0.0;
    }
    const double found = number_of(results_[output][lane]) - exact[output];
    switch (of.by) {
      case By::one:
        break;
      case By::output:
        return found * exact[of.of];
      case By::input:
        return found * number_of(words_[of.of][lane]);
      case By::inverse:
        return found / number_of(words_[of.of][lane]);
    }
    return found;
  }
  void try_ways_of_pool(const Place& place, std::uint32_t first) {
    exactly(place, exact_);
    run_at(place, &pool_[kLanes * first]);
    for (std::size_t output = 0; output < outputs_.size(); ++output) {
      Group& group = groups_[outputs_[output].group];
      group.least = std::min(group.least, exact_[output]), group.greatest = std::max(group.greatest, exact_[output]);
      std::uint32_t worst = 0;
      for (std::uint32_t lane = 1; lane < kLanes; ++lane) {
        if (std::fabs(error_of(output, lane, exact_)) > std::fabs(error_of(output, worst, exact_))) worst = lane;
      }
      add(group, std::fabs(error_of(output, worst, exact_)), place, output, worst, first);
    }
  }
  void add(Group& group, double error, const Place& place, std::size_t output, std::uint32_t lane,
           std::uint32_t first) {
    std::vector<Start>& found = group.found;
    if (error <= (found.size() < kStarts ? 0.0 : found.back().error)) return;
    const auto same = std::ranges::find(found, place, &Start::place);
    if (same != found.end()) {
      if (same->error >= error) return;
      found.erase(same);
    }
    Start start{error, place, output, std::vector<std::uint32_t>(kOperations)};
    for (std::uint32_t i = 0; i < kOperations; ++i) start.ways[i] = pool_[kLanes * (first + i) + lane];
    found.insert(std::ranges::find_if(found, [&](const Start& other) { return other.error < error; }),
                 std::move(start));
    if (found.size() > kStarts) found.pop_back();
    keep(group, error, place);
  }
  static void keep(Group& group, double error, const Place& place) {
    if (error > group.error) group.error = error, group.place = place;
  }

  // --- Singular places ---

  // Keeps the place that is nearest to one, for each root and each divisor.
  void watch(const Place& place) {
    if (singular.size() > nearest_.size()) nearest_.resize(std::min<std::size_t>(singular.size(), 64));
    for (std::size_t i = 0; i < std::min(singular.size(), nearest_.size()); ++i) {
      if (singular[i] != 0.0 &&
          std::fabs(singular[i]) < std::fabs(nearest_[i].operand)) {  // at 0 itself it often is exact
        nearest_[i] = {singular[i], place};
      }
    }
  }
  // A random step, and from there along the line on which the operand would be 0 if it were straight: half of the steps
  // from the nearest place, and the others from random ones, as at the nearest of all a text may be exact again.
  void walk() {
    const long steps = nearest_.empty() ? 0 : std::max(effort_ / 8 / static_cast<long>(nearest_.size()), 100L);
    std::array<double, kOutputs> exact{};
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      Near near = nearest_[i];
      const auto operand_at = [&](const Place& place) {
        exactly(place, exact);
        const double operand = i < singular.size() ? singular[i] : HUGE_VAL;
        if (operand != 0.0 && std::fabs(operand) < std::fabs(near.operand)) {
          near = {operand, place};
          try_ways_of_pool(place, random_.below(kPool));
        }
        return operand;
      };
      for (long step = 0; step < steps; ++step) {
        if (step > steps / 2 && step % kSteps == 0) {
          near = {HUGE_VAL, places_.drawn()};
          operand_at(near.place);
        }
        const Near from = near;
        const Place beside = places_.moved(from.place, false);
        const double there = operand_at(beside);
        const double part = from.operand / (from.operand - there);
        if (!std::isfinite(there) || !std::isfinite(part)) continue;
        Place aim = from.place;
        for (std::size_t axis = 0; axis < places_.size(); ++axis) {
          const Input& input = places_[axis];
          if (!input.is_float() || !input.moves()) continue;
          const double x = number_of(from.place[axis]);
          aim[axis] = bits_of(std::clamp(x + part * (number_of(beside[axis]) - x), input.lo, input.hi));
        }
        operand_at(places_.complete(aim));
      }
    }
  }

  // Between two random places, to where the exact values jump most: there a rounding may lead to the other side.
  void cross() {
    for (long pair = 0; pair < effort_ / 32; ++pair) {
      Place from = places_.drawn(), to = places_.drawn();
      for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!places_[i].is_float()) to[i] = from[i];
      }
      const std::size_t output = random_.below(static_cast<std::uint32_t>(outputs_.size()));
      double at_from = exact_at(from, output), at_to = exact_at(to, output);
      for (Place middle = places_.between(from, to); middle != from && middle != to;
           middle = places_.between(from, to)) {
        const double at_middle = exact_at(middle, output);
        if (std::fabs(at_middle - at_from) < std::fabs(at_to - at_middle)) {
          from = middle, at_from = at_middle;
        } else {
          to = middle, at_to = at_middle;
        }
      }
      try_ways_of_pool(from, random_.below(kPool));
      try_ways_of_pool(to, random_.below(kPool));
    }
  }
  double exact_at(const Place& place, std::size_t output) {
    exactly(place, exact_);
    return exact_[output];
  }

  // --- The climb ---

  // From the worst starts, and four times as long from the best quarter of them.
  void climb_in(std::size_t of) {
    Group& group = groups_[of];
    std::vector<Start> starts = std::move(group.found);
    long left = (effort_ / 2) / static_cast<long>(groups_.size());
    while (!starts.empty()) {
      const long each = starts.size() == 1 ? left : left / 3 / static_cast<long>(starts.size());
      for (Start& start : starts) {
        climb(start, each);
        keep(group, start.error, start.place);
      }
      left -= each * static_cast<long>(starts.size());
      std::ranges::stable_sort(starts, std::ranges::greater{}, &Start::error);
      starts.resize(starts.size() == 1 ? 0 : std::max<std::size_t>(starts.size() / 4, 1));
    }
  }
  void spread(const std::vector<std::uint32_t>& ways, std::vector<std::uint32_t>& over) const {
    for (std::uint32_t i = 0; i < operations_; ++i) std::fill_n(&over[kLanes * i], kLanes, ways[i]);
  }
  void climb(Start& start, long runs) {
    long unsuccessful = 0;
    climb_over_ways(start, runs);
    for (long round = 1; runs > 0; ++round) {
      if (climb_over_places(start, round % 8 == 0, runs)) {
        unsuccessful = 0;
      } else if (++unsuccessful % 16 == 0) {
        climb_over_ways(start, runs);
      }
    }
  }
  // 16 places beside it, with its ways.
  bool climb_over_places(Start& start, bool words, long& runs) {
    std::array<Place, kLanes> places;
    for (Place& place : places) place = places_.moved(start.place, words);
    for (std::size_t i = 0; i < kInputs; ++i) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) words_[i][lane] = places[lane][i];
    }
    spread(start.ways, base_);
    run_lanes(function_, base_.data(), words_, results_);
    runs -= 2;  // 16 exact values take as long as a run
    bool better = false;
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      exactly(places[lane], exact_);
      const double error = std::fabs(error_of(start.output, lane, exact_));
      if (error > start.error) start.error = error, start.place = places[lane], better = true;
    }
    return better;
  }
  void climb_over_ways(Start& start, long& runs) {
    exactly(start.place, exact_);
    spread(start.ways, base_);
    run_at(start.place, base_.data());
    double base = error_of(start.output, 0, exact_);
    const double sign = base < 0.0 ? -1.0 : 1.0;
    const auto signed_error = [&](std::uint32_t lane) { return sign * error_of(start.output, lane, exact_); };
    while (runs > 0) {
      struct Flip {
        double gain;
        std::uint32_t operation, bit;
      };
      std::vector<Flip> flips;
      tried_ = base_;
      for (std::uint32_t first = 0; first < operations_; first += kLanes / 2) {
        const std::uint32_t last = std::min(operations_, first + kLanes / 2);
        for (std::uint32_t i = first; i < last; ++i) {
          tried_[kLanes * i + 2 * (i - first)] ^= kUp, tried_[kLanes * i + 2 * (i - first) + 1] ^= kFused;
        }
        run_at(start.place, tried_.data());
        --runs;
        for (std::uint32_t i = first; i < last; ++i) {
          std::fill_n(&tried_[kLanes * i], kLanes, start.ways[i]);
          for (const std::uint32_t bit : {0u, 1u}) {
            const double gain = signed_error(2 * (i - first) + bit) - sign * base;
            if (gain > 0.0) flips.push_back({gain, i, bit});
          }
        }
      }
      if (flips.empty()) break;
      std::ranges::stable_sort(flips, std::ranges::greater{}, &Flip::gain);
      for (std::uint32_t lane = 0; lane < kLanes; ++lane) {  // all of them, three quarters ..., the best one
        const double part = lane == kLanes - 1 ? 0.0 : std::pow(0.75, lane);
        const auto count = std::max<std::size_t>(static_cast<std::size_t>(part * static_cast<double>(flips.size())), 1);
        for (std::size_t i = 0; i < count; ++i) {
          tried_[kLanes * flips[i].operation + lane] ^= flips[i].bit == 0 ? kUp : kFused;
        }
      }
      run_at(start.place, tried_.data());
      --runs;
      std::uint32_t best = 0;
      for (std::uint32_t lane = 1; lane < kLanes; ++lane) {
        if (signed_error(lane) > signed_error(best)) best = lane;
      }
      if (signed_error(best) <= sign * base) break;
      base = sign * signed_error(best);
      for (std::uint32_t i = 0; i < operations_; ++i) start.ways[i] = tried_[kLanes * i + best];
      spread(start.ways, base_);
    }
    start.error = std::max(start.error, std::fabs(base));
  }

  int function_;
  Random random_;
  long effort_;
  Places places_;
  std::vector<Output> outputs_;
  std::vector<std::uint32_t> pool_, base_, tried_;  // ways
  std::vector<Group> groups_;
  std::vector<Near> nearest_;
  std::uint32_t operations_ = 0;
  bool jumps_ = false;
  std::array<double, kOutputs> exact_{};
  Words words_{};
  Results results_{};
};

Output output_of(const std::string& text) {
  const std::vector<std::string> parts = parts_of(text);
  const std::map<std::string_view, By> kinds = {
      {"one", By::one}, {"output", By::output}, {"input", By::input}, {"inverse", By::inverse}};
  return {std::stoul(parts.at(0)), std::stod(parts.at(1)), kinds.at(parts.at(2)),
          parts.size() > 3 ? std::stoul(parts[3]) : 0};
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<Input> inputs;
  std::vector<Output> outputs;
  bool is_output = false, jumps = false;
  for (int i = 4; i < count; ++i) {
    const std::string text = arguments[i];
    if (text == "/") {
      is_output = true;
    } else if (text == "jumps") {
      jumps = true;
    } else if (is_output) {
      outputs.push_back(output_of(text));
    } else {
      inputs.push_back(input_of(text));
    }
  }
  Search search(std::atoi(arguments[1]), std::strtoull(arguments[2], nullptr, 10), std::atol(arguments[3]),
                std::move(inputs), std::move(outputs));
  if (jumps) search.take_jumps();
  search.run();
  search.print();
}

// Proves bounds of functions by running their text over boxes of places. Each line of the standard input is a job:
//
//   FUNCTION ARGUMENT... [OPTION=VALUE...]
//
//   FUNCTION    its number in bodies.inc
//   ARGUMENT    any, word:N, float:X, box:LO:HI for a float in there, or position:LO:HI for a coordinate in there,
//               in any cell; up to 16
//   outputs     bits: 1 for the first of the four words that it returns, 2 for the second, and so on
//   measure     error; most or least, the ends of the range; exact_most or exact_least, those in exact arithmetic;
//               slope, by a place that is off by 1 along each axis; or error_by_length, of a component of a direction,
//               times the length of the vector
//   longest     the k-th smallest length, and the length of such a vector, are known to be this at most
//   unit        the size of a length of the text, in the result and in `longest`
//   most        boxes
//   tolerance   relative: how far the bound may be from the largest that was seen
//   target      a bound that is small enough
//   bits        of a place in HN_FIXED, which is a multiple of 2^-bits: the text cuts it, or rounds it
//   seconds     which is not exceeded much
//
// and each line of the output is an object of JSON. "problem" is empty, or is the reason why the bound is infinite, and
// "frames" are then the addresses of the calls on the way to that.
#include <chrono>
#include <cstring>
#include <ctime>
#include <iostream>
#include <optional>
#include <queue>
#include <sstream>

#include "search.hpp"

namespace hn::prover {
namespace {

#define FUNCTION(...) \
  [](uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) -> uvec4 { __VA_ARGS__ },
#define float Float
#define int Int
const Body kBodies[] = {
#include "bodies.inc"
};
#undef float
#undef int

// For the text's own constants, which are made before the program begins.
struct Constants {
  Vector<Symbol> symbols;
  std::vector<Node> nodes;
} constants;

std::vector<std::pair<double, std::vector<void*>>> parts;  // of the bound in a box that is explained

struct Box {
  std::vector<double> lo, side;
  std::optional<Cut> cut;
  double found = 0;
  int split = 0;  // bits of each number of a hash that divide its words
  bool operator<(const Box& b) const { return found < b.found; }
};

Float place(std::size_t axis, double lo, double side) {
  Form f;
  f.range = {lo, lo + side};
  f.mid = point(middle(f.range));
  f.grid = std::max(lo > 0 ? std::ilogb(lo) - 23 : kNoGrid, kFixed ? -place_bits : kNoGrid);
  f.ends[0] = {lo, lo}, f.ends[1] = {lo + side, lo + side};
  f.place = Form::kNone;
  if (side > 0 || kFixed) {
    const double half = reach(f.range, f.mid.lo);
    f.place = symbol(kPlace, {-half, half});
    f.terms = {{f.place, {1, 1}}};
    places.push_back({f.place, axis, f.mid.lo, f.range.lo, f.range.hi});
  }
  return Float::of(f);
}

Uint word_of(const Argument& argument, const Box& box, std::size_t& axis) {
  switch (argument.is) {
    case Argument::kAny:
      return Uint(Word::made_by(new_step('A', static_cast<int>(steps.size()))));
    case Argument::kWord:
      return Uint(argument.word);
    case Argument::kFloat:
      return floatBitsToUint(Float(static_cast<float>(argument.lo)));
    case Argument::kBox: {
      const std::size_t i = axis++;
      return floatBitsToUint(place(i, box.lo[i], box.side[i]));
    }
    case Argument::kPosition: {
      const std::size_t i = axis++;
      const Form all = position(argument.lo, argument.hi - 1, box.lo[i], box.lo[i] + box.side[i]);
      const Float x = Float::of(all), cell = floor(x), fraction = Float::of(plus(all, cell.form(), -1));
      for (const Float part : {cell, fraction})
        nodes[part.n].made = 'P', nodes[part.n].left = static_cast<int>(2 * i + (part.n == cell.n ? 16 : 17));
      return floatBitsToUint(made(x, '+', cell, fraction));
    }
  }
  std::abort();
}

double measured(const Job& job, Float number) {
  const Form& f = number.form();
  switch (job.measure) {
    case kErrorByLength:
      return nodes[number.n].by_length * job.unit;
    case kLargestError:
      return f.error().size();
    case kMost:
      return f.range.hi;
    case kLeast:
      return -f.range.lo;
    case kExactMost:
      return f.exact().hi;
    case kExactLeast:
      return -f.exact().lo;
    case kSlope:
      return f.moved();
  }
  std::abort();
}

constexpr int kMostPaths = 1000, kMostSeams = 64;  // each two of the latter are compared

// The results of a path.
struct Outcome {
  std::vector<Decision> path;
  std::vector<int> numbers;  // nodes
};

// The largest difference of paths, in exact arithmetic, that parted where rounding decides.
double apart(const std::vector<Outcome>& outcomes) {
  double most = 0;
  for (const Outcome& a : outcomes) {
    for (const Outcome& b : outcomes) {
      if (&a == &b) break;
      std::size_t i = 0;
      while (i < a.path.size() && i < b.path.size() && a.path[i].taken == b.path[i].taken) ++i;
      if (i == a.path.size() || i == b.path.size() || !a.path[i].rounds) continue;
      for (std::size_t j = 0; j < a.numbers.size(); ++j)
        if (a.numbers[j] != b.numbers[j])
          most = std::max(most, numbering.apart(a.numbers[j], b.numbers[j], a.path[i].number));
    }
  }
  return most;
}

double found_in(const Job& job, Box& box, std::string& problem) {
  double largest = job.measure == kLargestError || job.measure == kSlope ? 0 : -INFINITY;
  std::vector<Outcome> outcomes;
  bool starts = true;
  std::array<uvec4, 4> in;
  for (int paths = 0;; ++paths) {
    if (paths > kMostPaths || outcomes.size() > kMostSeams) {
      problem = "too many paths";
      return INFINITY;
    }
    if (starts) {
      symbols = constants.symbols, nodes = constants.nodes;
      path.clear(), outcomes.clear(), steps.resize(1), places.clear(), all_taken.clear(), numbering.clear();
      last_word = 0, last_common = 0;
      linears.clear();
      std::fill_n(along, kAxes, Along{});
    }
    same.clear();
    ++run;
    decided = 0;
    try {
      std::size_t axis = 0;
      for (std::size_t i = 0; i < 16 && starts; ++i) {
        uvec4& v = in[i / 4];
        (i % 4 == 0 ? v.x : i % 4 == 1 ? v.y : i % 4 == 2 ? v.z : v.w) = word_of(job.arguments[i], box, axis);
      }
      if (starts) corners = 1 << std::min<std::size_t>(axis, kAxes);
      starts = false;
      const uvec4 found = job.function(in[0], in[1], in[2], in[3]);
      const Uint* const out[] = {&found.x, &found.y, &found.z, &found.w};
      const bool rounds = std::any_of(path.begin(), path.end(), [](const Decision& d) { return d.rounds; });
      Outcome outcome{path, {}};
      for (unsigned i = 0; i < 4; ++i) {
        if (!(job.outputs >> i & 1)) continue;
        const Float number = uintBitsToFloat(*out[i]);
        const double found_here = measured(job, number);
        for (const Term& t : number.form().terms) {
          if (explains && symbols[t.symbol].kind == kError)
            parts.push_back({(t.d * symbols[t.symbol].range).size(), origins[t.symbol]});
        }
        if (!(found_here <= largest)) largest = std::isnan(found_here) ? INFINITY : found_here;
        outcome.numbers.push_back(number.n);
      }
      if (rounds) outcomes.push_back(std::move(outcome));
      if (next_path()) continue;
      return job.measure == kLargestError && !given ? largest + apart(outcomes) : largest;
    } catch (Again) {
      starts = true, paths = -1;
    } catch (const Cut& at) {
      box.cut = at;
      return INFINITY;
    } catch (const TooLarge& box_is) {
      problem = box_is.why;
      return INFINITY;
    }
  }
}

// As above, in each box with the classes of words that were wanted where as many bits were split.
std::array<std::vector<Division>, kMostSplit + 1> wanted;

double measured_in(const Job& job, Box& box, std::string& problem) {
  split = box.split;
  if (split > 0 && wanted[split].empty()) wanted[split] = wanted[split - 1];
  divisions.swap(wanted[split]);
  const double found = found_in(job, box, problem);
  divisions.swap(wanted[split]);
  return found;
}

}  // namespace

double first_half(double lo, double side) {
  const double at = lo + side / 2, unit = std::ldexp(1.0, -place_bits);
  return (kFixed ? std::floor(at / unit) * unit : static_cast<double>(static_cast<float>(at))) - lo;
}

Proven prove(const Job& job) {
  may_split = false, wanted = {}, divisions = {}, bits_of_chosen = 0, given = job.given,
  longest = job.longest / job.unit;
  Proven proven;
  place_bits = job.bits, wants_range = job.measure != kLargestError;
  const double unit = std::ldexp(1.0, -place_bits);
  // In HN_FIXED both ends of a cell stand alone: there differences of ramps are largest.
  std::vector<Box> first(1);
  for (const Argument& argument : job.arguments) {
    if (argument.is != Argument::kBox && argument.is != Argument::kPosition) continue;
    const Interval ends = argument.is == Argument::kBox ? Interval{argument.lo, argument.hi} : Interval{0, 1};
    std::vector<Interval> parts{ends};
    if (kFixed && ends.lo == 0 && ends.hi == 1) parts = {{0, 0}, {unit, 1 - unit}, {1, 1}};
    std::vector<Box> boxes;
    for (const Interval& part : parts) {
      for (Box box : first) {
        box.lo.push_back(part.lo), box.side.push_back(part.hi - part.lo);
        boxes.push_back(box);
      }
    }
    first = std::move(boxes);
  }
  std::priority_queue<Box> queue;
  for (Box& box : first) {
    box.found = measured_in(job, box, proven.problem);
    queue.push(box);
  }
  proven.boxes = first.size();
  const std::size_t dims = first[0].lo.size();
  double& least = proven.at_point;
  int in_vain = 0;  // so many times more classes were of no use
  const std::clock_t start = std::clock();
  const auto has_time = [&] { return static_cast<double>(std::clock() - start) < job.seconds * CLOCKS_PER_SEC; };
  while (dims > 0 && queue.top().found > std::max(job.target, least * (1 + job.tolerance)) && proven.boxes < job.most &&
         has_time()) {
    Box box = queue.top();
    queue.pop();
    const std::optional<Cut> cut = std::exchange(box.cut, {});
    Box middle = box;
    for (std::size_t i = 0; i < dims; ++i)
      middle.lo[i] = box.lo[i] + first_half(box.lo[i], box.side[i]), middle.side[i] = 0;
    if (box.found < INFINITY && !(job.target > 0)) {
      const bool tiny = *std::max_element(box.side.begin(), box.side.end()) < 0x1p-18;
      least = std::max(least, tiny ? box.found : measured_in(job, middle, proven.problem));
    }
    // A longest axis is halved, or words are divided into more classes if this brings twice as much.
    const std::size_t longest = std::max_element(box.side.begin(), box.side.end()) - box.side.begin();
    if (box.side[longest] == 0) {
      queue.push(box);
      break;
    }
    std::array<Box, 2> halves{box, box};
    const std::size_t axis = cut ? cut->axis : longest;
    double &lo = halves[1].lo[axis], &side = halves[1].side[axis];
    const double last = !cut ? lo + first_half(lo, side) : kFixed ? std::floor(cut->last / unit) * unit : cut->last;
    const double next = kFixed ? last + unit : cut ? std::nextafterf(cut->last, INFINITY) : last;
    halves[0].side[axis] = last - lo;
    side = lo + side - next, lo = next;
    for (Box& half : halves) half.found = measured_in(job, half, proven.problem), ++proven.boxes;
    if (!cut && may_split && box.split < kMostSplit && in_vain < 20) {
      Box finer = box;
      ++finer.split, ++proven.boxes;
      finer.found = measured_in(job, finer, proven.problem);
      const double most = std::max(halves[0].found, halves[1].found);
      const bool helps = finer.found < most && (most == INFINITY || box.found - finer.found > 2 * (box.found - most));
      in_vain = helps ? 0 : in_vain + 1;
      if (helps) {
        queue.push(finer);
        continue;
      }
    }
    for (Box& half : halves) queue.push(half);
  }
  Box worst = queue.top();
  for (std::size_t i = 0; i < dims; ++i) proven.box.push_back({worst.lo[i], worst.lo[i] + worst.side[i]});
  proven.problem.clear();
  proven.bound = worst.found;
  if (proven.bound == INFINITY) measured_in(job, worst, proven.problem);
  if (!proven.problem.empty()) proven.frames = frames;
#ifdef PROVER_TRACE
  explains = true, parts.clear();
  if (proven.problem.empty()) measured_in(job, worst, proven.problem);
  explains = false, proven.parts = parts;
#endif
  return proven;
}

namespace {

Argument argument_of(const std::string& text) {
  Argument found;
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon), rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "word") {
    found.is = Argument::kWord;
    found.word = static_cast<std::uint32_t>(std::stoll(rest));
  } else if (kind == "float") {
    found.is = Argument::kFloat;
    found.lo = std::stod(rest);
  } else if (kind == "box" || kind == "position") {
    found.is = kind == "box" ? Argument::kBox : Argument::kPosition;
    found.lo = std::stod(rest);
    found.hi = std::stod(rest.substr(rest.find(':') + 1));
  }
  return found;
}

void set(Job& job, const std::string& option, const std::string& value) {
  static const char* const kMeasures[] = {"error",       "most",  "least",          "exact_most",
                                          "exact_least", "slope", "error_by_length"};
  if (option == "outputs") job.outputs = static_cast<unsigned>(std::stoul(value));
  if (option == "bits") job.bits = std::stoi(value);
  if (option == "most") job.most = std::stoul(value);
  if (option == "tolerance") job.tolerance = std::stod(value);
  if (option == "target") job.target = std::stod(value);
  if (option == "given") job.given = value != "0";
  if (option == "longest") job.longest = std::stod(value);
  if (option == "unit") job.unit = std::stod(value);
  if (option == "seconds") job.seconds = std::stod(value);
  if (option == "measure")
    job.measure = static_cast<Measure>(std::find(kMeasures, std::end(kMeasures), value) - kMeasures);
}

std::string json(double x) {
  char text[32];
  std::snprintf(text, sizeof text, std::isinf(x) ? "Infinity" : "%.17g", x);
  return text;
}

}  // namespace
}  // namespace hn::prover

int main() {
  using namespace hn::prover;
  constants = {symbols, nodes};
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    Job job;
    std::size_t function = 0, count = 0;
    words >> function;
    job.function = kBodies[function];
    for (std::string word; words >> word;) {
      if (const std::size_t equals = word.find('='); equals != std::string::npos)
        set(job, word.substr(0, equals), word.substr(equals + 1));
      else
        job.arguments.at(count++) = argument_of(word);
    }
    const auto start = std::chrono::steady_clock::now();
    Proven proven;
    {
      const Proving rounding_up;
      try {
        proven = prove(job);
      } catch (const Unseen& unseen) {
        proven.bound = INFINITY;
        proven.problem = unseen.step;
        proven.frames = frames;
      }
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::printf("{\"bound\": %s, \"at_point\": %s, \"boxes\": %zu, \"seconds\": %.2f, \"problem\": \"%s\", \"box\": [",
                json(proven.bound).c_str(), json(proven.at_point).c_str(), proven.boxes, took.count(),
                proven.problem.c_str());
    for (std::size_t i = 0; i < proven.box.size(); ++i)
      std::printf("%s[%.17g, %.17g]", i ? ", " : "", proven.box[i].lo, proven.box[i].hi);
    const auto addresses = [](const std::vector<void*>& frames) {
      for (std::size_t i = 0; i < frames.size(); ++i)
        std::printf("%s%zu", i ? ", " : "", reinterpret_cast<std::size_t>(frames[i]));
    };
    std::printf("], \"frames\": [");
    addresses(proven.frames);
    std::printf("], \"parts\": [");
    for (std::size_t i = 0; i < proven.parts.size(); ++i) {
      std::printf("%s[%.17g, [", i ? ", " : "", proven.parts[i].first);
      addresses(proven.parts[i].second);
      std::printf("]]");
    }
    std::puts("]}");
    std::fflush(stdout);
  }
}

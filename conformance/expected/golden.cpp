#include "expected/golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

#include "base/digest.hpp"
#include "base/file.hpp"
#include "base/output/text.hpp"

namespace hn {
namespace {

constexpr std::string_view kGoldenExtension = ".golden";
constexpr std::size_t kMostRows = 1u << 20;
constexpr std::size_t kMostDigestPoints = 1u << 20;

int hex_digits(WordType type) {
  switch (type) {
    case WordType::u32:
    case WordType::i32:
    case WordType::f32:
      break;
    case WordType::f64:
      return 16;
  }
  return 8;
}

bool is_float(std::uint64_t bits) {
  const auto value = std::bit_cast<double>(bits);
  return static_cast<double>(static_cast<float>(value)) == value;
}

// hn_hash and hn_lattice have one. What comes of a hash is tried well enough by rows.
bool has_digest(const Function& function) {
  return function.family == Family::hash && function.outputs.front().type == WordType::u32;
}

// Takes the text up to the separator off the front.
std::string_view take(std::string_view& text, char separator) {
  const auto end = std::min(text.find(separator), text.size());
  const auto item = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return item;
}

template <typename T>
bool parse_number(std::string_view text, T& value, int base = 10) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc() && stop == text.data() + text.size();
}

// "-1,2,3": whole numbers, negative ones in two's complement.
bool parse_list(std::string_view text, std::vector<std::uint32_t>& list) {
  while (!text.empty()) {
    std::int64_t number = 0;
    if (!parse_number(take(text, ','), number)) return false;
    if (number < std::numeric_limits<std::int32_t>::min() || number > std::numeric_limits<std::uint32_t>::max()) {
      return false;
    }
    list.push_back(static_cast<std::uint32_t>(number));
  }
  return !list.empty();
}

class Parser {
 public:
  Parser(std::string_view text, std::string_view path, const Function& function, const Configuration& configuration)
      : rest_(text), path_(path), function_(function), configuration_(configuration) {}

  Result<Golden> run() {
    std::size_t rows = 0;
    HN_DO(header(rows));
    for (std::size_t i = 0; i < rows; ++i) {
      if (!next_line()) return error(fmt::format("the file ends after {} of {} rows", i, rows));
      HN_DO(row());
    }
    if (has_digest(function_)) {
      if (!next_line()) return error("the file ends where the digest should be");
      HN_DO(digest());
    }
    if (next_line()) return error(fmt::format("the file should end before {}", in_quotes(current_)));
    return std::move(golden_);
  }

 private:
  tl::unexpected<Error> error(std::string_view what) const {
    return fail(fmt::format("{}:{}: {}", path_, line_, what));
  }

  bool next_line() {
    if (rest_.empty()) return false;
    current_ = take(rest_, '\n');
    ++line_;
    return true;
  }

  // The next line is there, and is right: what it should be.
  template <typename Predicate>
  Result<void> expect(std::string_view what, Predicate is_right) {
    if (!next_line()) return error(fmt::format("the file ends where {} should be", what));
    if (!is_right(current_)) return error(fmt::format("{} should be {}", in_quotes(current_), what));
    return {};
  }

  Result<void> expect_line(std::string_view line) {
    return expect(fmt::format("\"{}\"", line), [&](std::string_view current) { return current == line; });
  }

  Result<void> header(std::size_t& rows) {
    for (const std::string& line : {std::string("hashnoise golden 1"), fmt::format("function {}", function_.id),
                                    fmt::format("hash {}", golden_configuration(function_, configuration_)),
                                    fmt::format("arithmetic {}", golden_arithmetic(function_, configuration_))}) {
      HN_DO(expect_line(line));
    }
    HN_DO(expect("\"bits VERSION\"", [](std::string_view line) { return line.starts_with("bits "); }));
    HN_DO(expect_line(fmt::format("columns {}", function_.columns)));
    return expect(fmt::format("\"rows NUMBER\", from 1 to {}", kMostRows), [&](std::string_view line) {
      return line.starts_with("rows ") && parse_number(line.substr(5), rows) && rows != 0 && rows <= kMostRows;
    });
  }

  template <typename Word>
  Result<void> words(std::string_view text, const std::vector<Column>& columns, std::vector<Word>& out) {
    for (const Column& column : columns) {
      const auto digits = take(text, ' ');
      Word value = 0;
      if (digits.size() != static_cast<std::size_t>(hex_digits(column.type)) || !parse_number(digits, value, 16)) {
        return error(fmt::format("{} should be the {} hexadecimal digits of column {}", in_quotes(digits),
                                 hex_digits(column.type), column.name));
      }
      out.push_back(value);
    }
    if (!text.empty()) return error(fmt::format("{} should not follow the last column", in_quotes(text)));
    return {};
  }

  Result<void> row() {
    const auto equals = current_.find(" = ");
    if (equals == std::string_view::npos) {
      return error(fmt::format("{} should be a row, \"inputs = values\"", in_quotes(current_)));
    }
    GoldenRow row{line_, {}, {}};
    HN_DO(words(current_.substr(0, equals), function_.inputs, row.inputs));
    HN_DO(words(current_.substr(equals + 3), function_.outputs, row.values));
    for (std::size_t i = 0; i < row.values.size() && has_exact_values(function_, configuration_); ++i) {
      if (function_.outputs[i].type != WordType::f64) continue;
      if (!is_float(row.values[i])) return error(fmt::format("{:016x} should be a float", row.values[i]));
    }
    golden_.rows.push_back(std::move(row));
    return {};
  }

  Result<void> digest() {
    std::string_view text = current_;
    GoldenDigest digest;
    bool valid = take(text, ' ') == "digest";
    while (valid && !text.empty()) {
      auto item = take(text, ' ');
      const auto key = take(item, '=');
      if (key == "origin")
        valid = parse_list(item, digest.origin);
      else if (key == "size")
        valid = parse_list(item, digest.size);
      else if (key == "seed")
        valid = parse_number(item, digest.seed);
      else if (key == "fnv1a64")
        valid = item.size() == 16 && parse_number(item, digest.fnv1a64, 16);
      else
        valid = false;
    }
    const std::size_t axes = function_.inputs.size() - (function_.seed_word() < 0 ? 0 : 1);
    if (!valid || digest.origin.size() != axes || digest.size.size() != axes || digest.points() == 0 ||
        digest.points() > kMostDigestPoints || digest.fnv1a64 == 0) {
      return error(fmt::format("{} should be \"digest origin=X,.. size=X,.. [seed=N] fnv1a64=16 digits\", with {} axes",
                               in_quotes(current_), axes));
    }
    golden_.digest = std::move(digest);
    return {};
  }

  std::string_view rest_;
  std::string_view path_;
  const Function& function_;
  const Configuration& configuration_;
  std::string_view current_;
  int line_ = 0;
  Golden golden_;
};

}  // namespace

std::size_t GoldenDigest::points() const {
  std::size_t count = 1;
  for (const std::uint32_t extent : size) {
    if (extent > kMostDigestPoints) return kMostDigestPoints + 1;
    count = std::min<std::size_t>(count * extent, kMostDigestPoints + 1);
  }
  return count;
}

std::vector<std::uint32_t> GoldenDigest::inputs() const {
  std::vector<std::uint32_t> words(points() * kInputWords);
  for (std::size_t i = 0; i < points(); ++i) {
    std::size_t rest = i;
    for (std::size_t axis = size.size(); axis-- > 0; rest /= size[axis]) {
      words[i * kInputWords + axis] = origin[axis] + static_cast<std::uint32_t>(rest % size[axis]);
    }
    words[i * kInputWords + size.size()] = seed;
  }
  return words;
}

std::uint32_t result_bits(const Column& column, std::uint64_t value) {
  if (column.type != WordType::f64) return static_cast<std::uint32_t>(value);
  return std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<double>(value)));
}

std::string_view golden_arithmetic(const Function& function, const Configuration& configuration) {
  if (function.exact()) return "exact";
  return has_exact_values(function, configuration) ? "fixed" : "fast";
}

std::string_view golden_configuration(const Function& function, const Configuration& configuration) {
  const bool fixed = configuration.arithmetic == Arithmetic::fixed;
  return fixed ? configuration.name : configuration_name(function, configuration);
}

Result<void> check_golden_folder(const std::filesystem::path& directory) {
  constexpr std::string_view kHint =
      "--golden wants the folder of the golden files, which is installed with the program";
  std::error_code error;
  std::filesystem::directory_iterator entries(directory, error);
  if (error) return fail(fmt::format("cannot read the folder {}: {}; {}", directory.string(), error.message(), kHint));
  const bool any = std::any_of(begin(entries), end(entries),
                               [](const auto& entry) { return entry.path().extension() == kGoldenExtension; });
  if (!any) return fail(fmt::format("there is no golden file in {}; {}", directory.string(), kHint));
  return {};
}

std::filesystem::path golden_path(const std::filesystem::path& directory, const Function& function,
                                  const Configuration& configuration) {
  return directory /
         fmt::format("{}.{}{}", function.id, golden_configuration(function, configuration), kGoldenExtension);
}

Result<Golden> read_golden(const std::filesystem::path& path, const Function& function,
                           const Configuration& configuration) {
  HN_TRY(const auto text, read_file(path, "it is a golden file, and tools/golden writes it"));
  auto golden = parse_golden(text, path.string(), function, configuration);
  if (!golden) return fail(fmt::format("{}; tools/golden writes golden files", golden.error().message));
  return golden;
}

Result<Golden> parse_golden(std::string_view text, std::string_view path, const Function& function,
                            const Configuration& configuration) {
  return Parser(text, path, function, configuration).run();
}

std::uint64_t fnv1a64(const std::vector<std::uint32_t>& words) { return fnv1a64(bytes_of(std::span(words))); }

}  // namespace hn

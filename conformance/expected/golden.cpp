#include "expected/golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>
#include <optional>
#include <set>

#include "base/file.hpp"
#include "base/text.hpp"
#include "library/digest.hpp"
#include "output/encoding.hpp"

namespace hn {
namespace {

constexpr std::string_view kGoldenExtension = ".golden";
constexpr std::string_view kEquals = " = ";
constexpr std::string_view kNoValues = "-";
constexpr std::size_t kMostRows = 1u << 20;
constexpr std::size_t kMostDigestPoints = 1u << 20;

int hex_digits(WordType type) { return type == WordType::f64 ? 16 : 8; }

bool is_float(std::uint64_t bits) {
  const auto value = std::bit_cast<double>(bits);
  return static_cast<double>(static_cast<float>(value)) == value;
}

// hn_hash and hn_lattice have a digest. Rows are enough for the functions above them.
bool has_digest(const Function& function) {
  return function.family == Family::hash && function.outputs.front().type == WordType::u32;
}

// Takes the text up to the separator off the front.
std::string_view take(std::string_view& text, std::string_view separator) {
  const auto end = std::min(text.find(separator), text.size());
  const auto item = text.substr(0, end);
  text.remove_prefix(std::min(end + separator.size(), text.size()));
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
    if (!parse_number(take(text, ","), number)) return false;
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
      : rest_(text), path_(path), function_(function), settings_(golden_settings(function)) {
    const auto is_own = [own = golden_setting(function, configuration)](const GoldenSetting& setting) {
      return setting.name == own;
    };
    own_ = std::ranges::find_if(settings_, is_own);
    has_fixed_ = std::ranges::any_of(
        settings_, [](const GoldenSetting& setting) { return setting.configuration->arithmetic == Arithmetic::fixed; });
  }

  Result<Golden> run() {
    if (own_ == settings_.end()) return error("the configuration has no values of the function");
    std::size_t rows = 0;
    HN_DO(header(rows));
    for (std::size_t i = 0; i < rows; ++i) {
      if (!next_line()) return error(fmt::format("the file ends after {} of {} rows", i, rows));
      HN_DO(row());
    }
    for (auto setting = settings_.begin(); has_digest(function_) && setting != settings_.end(); ++setting) {
      if (!next_line()) return error("the file ends where the digest should be");
      HN_DO(digest(setting));
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
    current_ = take(rest_, "\n");
    ++line_;
    return true;
  }

  // The next line is there, and is right.
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
    HN_DO(expect_line("hashnoise golden 2"));
    HN_DO(expect_line(fmt::format("function {}", function_.id)));
    HN_DO(expect("\"calls hn_FUNCTION\"", [](std::string_view line) { return line.starts_with("calls hn_"); }));
    golden_.calls = current_.substr(std::string_view("calls ").size());
    HN_DO(expect("\"bits VERSION\"", [](std::string_view line) { return line.starts_with("bits "); }));
    HN_DO(expect_line(fmt::format("columns {}", columns_of(function_))));
    std::string settings = "settings";
    for (const GoldenSetting& setting : settings_) settings += " " + setting.name;
    HN_DO(expect_line(settings));
    return expect(fmt::format("\"rows NUMBER\", from 1 to {}", kMostRows), [&](std::string_view line) {
      return line.starts_with("rows ") && parse_number(line.substr(5), rows) && rows != 0 && rows <= kMostRows;
    });
  }

  template <typename Word>
  Result<void> words(std::string_view text, const std::vector<Column>& columns, std::vector<Word>& out) {
    for (const Column& column : columns) {
      const auto digits = take(text, " ");
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
    std::string_view text = current_;
    if (text.ends_with(' ')) return error(fmt::format("{} should not end with a space", in_quotes(text)));
    GoldenRow row{line_, {}, {}};
    HN_DO(words(take(text, kEquals), function_.inputs, row.inputs));
    // Whether only fixed arithmetic has values: the first other setting decides, and the others have to agree.
    std::optional<bool> alone;
    for (auto setting = settings_.begin(); setting != settings_.end(); ++setting) {
      const auto values = take(text, kEquals);
      if (setting->configuration->arithmetic != Arithmetic::fixed) {
        if (!alone) alone = values == kNoValues && has_fixed_;
        if ((*alone || alone_) && values != kNoValues) {
          return error(fmt::format("{} should be \"{}\", as with the setting or in the row before", in_quotes(values),
                                   kNoValues));
        }
        if (*alone) continue;
      }
      row.values.clear();
      HN_DO(words(values, function_.outputs, row.values));
      for (std::size_t i = 0; i < row.values.size() && has_exact_values(function_, *setting->configuration); ++i) {
        if (function_.outputs[i].type != WordType::f64) continue;
        if (!is_float(row.values[i])) return error(fmt::format("{:016x} should be a float", row.values[i]));
      }
      if (setting == own_) golden_.rows.push_back(row);
    }
    if (!text.empty()) return error(fmt::format("{} should not follow the last values", in_quotes(text)));
    alone_ = alone.value_or(false);
    return {};
  }

  Result<void> digest(std::vector<GoldenSetting>::const_iterator setting) {
    std::string_view text = current_;
    GoldenDigest digest;
    const std::string_view name = std::string_view(setting->name).substr(0, setting->name.find(':'));
    bool valid = take(text, " ") == "digest" && take(text, " ") == name;
    while (valid && !text.empty()) {
      auto item = take(text, " ");
      const auto key = take(item, "=");
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
      return error(
          fmt::format("{} should be \"digest {} origin=X,.. size=X,.. [seed=N] fnv1a64=16 digits\", with {} axes",
                      in_quotes(current_), name, axes));
    }
    if (setting == own_) golden_.digest = std::move(digest);
    return {};
  }

  std::string_view rest_;
  std::string_view path_;
  const Function& function_;
  const std::vector<GoldenSetting> settings_;
  std::vector<GoldenSetting>::const_iterator own_;
  std::string_view current_;
  int line_ = 0;
  bool has_fixed_ = false;
  bool alone_ = false;  // whether the last row has values of fixed arithmetic alone
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

std::string golden_setting(const Function& function, const Configuration& configuration) {
  if (function.exact()) return fmt::format("{}:exact", configuration_name(function, configuration));
  if (has_exact_values(function, configuration)) return fmt::format("{}:fixed", configuration.name);
  return fmt::format("{}:fast", configuration_name(function, configuration));
}

std::vector<GoldenSetting> golden_settings(const Function& function) {
  std::vector<GoldenSetting> settings;
  for (const Configuration& configuration : all_configurations()) {
    if (configuration.arithmetic == Arithmetic::precise || !covers(configuration, function)) continue;
    settings.push_back({golden_setting(function, configuration), &configuration});
  }
  return settings;
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

std::filesystem::path golden_path(const std::filesystem::path& directory, const Function& function) {
  return directory / fmt::format("{}{}", function.id, kGoldenExtension);
}

Result<Golden> read_golden(const std::filesystem::path& path, const Function& function,
                           const Configuration& configuration) {
  HN_TRY(const auto text, read_file(path, "it is a golden file, and tools/make golden writes it"));
  auto golden = parse_golden(text, path.string(), function, configuration);
  if (!golden) return fail(fmt::format("{}; tools/make golden writes golden files", golden.error().message));
  return golden;
}

Result<Golden> parse_golden(std::string_view text, std::string_view path, const Function& function,
                            const Configuration& configuration) {
  return Parser(text, path, function, configuration).run();
}

std::uint64_t fnv1a64(const std::vector<std::uint32_t>& words) { return fnv1a64(bytes_of(std::span(words))); }

namespace {

std::vector<ExactSet> make_exact_sets() {
  std::vector<const Function*> functions;
  for (const Function& function : all_functions()) functions.push_back(&function);
  std::ranges::sort(functions, {}, &Function::id);
  std::vector<ExactSet> sets;
  for (const Function* function : functions) {
    for (const GoldenSetting& setting : golden_settings(*function)) {
      if (has_exact_values(*function, *setting.configuration)) sets.push_back({function->id, setting.name});
    }
  }
  return sets;
}

}  // namespace

const std::vector<ExactSet>& exact_sets() {
  static const std::vector<ExactSet> kSets = make_exact_sets();
  return kSets;
}

std::string golden_checksum(const std::filesystem::path& directory) {
  std::set<std::string> names;
  std::error_code none;  // a folder that is missing is an error of each case
  for (const auto& entry : std::filesystem::directory_iterator(directory, none)) {
    if (entry.path().extension() == ".golden") names.insert(entry.path().filename().string());
  }
  std::uint32_t checksum = 0;
  for (const std::string& name : names) checksum = crc32_of(read_file(directory / name).value_or(""), checksum);
  return fmt::format("{:08x}", checksum);
}

}  // namespace hn

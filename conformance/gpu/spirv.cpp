#include "gpu/spirv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <glslang/SPIRV/spirv.hpp>
#include <map>
#include <set>
#include <spirv-tools/libspirv.hpp>

#include "base/file.hpp"

namespace hn {
namespace {

constexpr std::size_t kHeader = 5;  // words before the first instruction

// Visits the module word by word: each instruction and its operands, from the result on if it has one.
template <typename Visit>
void for_each_instruction(std::span<const std::uint32_t> words, Visit visit) {
  for (std::size_t at = kHeader; at < words.size();) {
    const std::size_t length = words[at] >> 16;
    if (length == 0 || at + length > words.size()) break;
    visit(static_cast<spv::Op>(words[at] & 0xFFFFu), words.subspan(at + 1, length - 1));
    at += length;
  }
}

std::string text_of(std::span<const std::uint32_t> operands) { return reinterpret_cast<const char*>(operands.data()); }

bool rounds(spv::Op operation) {
  return operation == spv::OpFAdd || operation == spv::OpFSub || operation == spv::OpFMul ||
         operation == spv::OpVectorTimesScalar || operation == spv::OpDot || operation == spv::OpFDiv;
}

}  // namespace

Result<void> validate_spirv(std::span<const std::uint32_t> words) {
  const std::uint32_t minor = words.size() > 1 ? words[1] >> 8 & 0xFFu : 0;
  spvtools::SpirvTools tools(minor == 0   ? SPV_ENV_VULKAN_1_0
                             : minor <= 3 ? SPV_ENV_VULKAN_1_1
                             : minor <= 5 ? SPV_ENV_VULKAN_1_2
                                          : SPV_ENV_VULKAN_1_3);
  std::string log;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
    log += fmt::format("word {}: {}\n", position.index, message);
  });
  if (!tools.Validate(words.data(), words.size())) return fail("spirv-val rejects the SPIR-V", log);
  return {};
}

std::optional<std::string> spirv_text(std::string_view bytes) {
  std::string text;
  const bool done = spvtools::SpirvTools(SPV_ENV_UNIVERSAL_1_6)
                        .Disassemble(spirv_of(bytes), &text,
                                     SPV_BINARY_TO_TEXT_OPTION_NO_HEADER | SPV_BINARY_TO_TEXT_OPTION_INDENT |
                                         SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES);
  return done ? std::optional(text) : std::nullopt;
}

std::int64_t count_spirv(std::span<const std::uint32_t> words) {
  std::int64_t count = 0;
  bool inside = false;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t>) {
    if (operation == spv::OpFunctionEnd) inside = false;
    if (inside && operation != spv::OpLabel && operation != spv::OpFunctionParameter) ++count;
    if (operation == spv::OpFunction) inside = true;
  });
  return count;
}

std::vector<std::string> relaxed_precision(std::span<const std::uint32_t> words) {
  std::map<std::uint32_t, std::string> names;
  std::vector<std::uint32_t> relaxed;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    if (operation == spv::OpName) names[operands[0]] = text_of(operands.subspan(1));
    const bool relaxes = operation == spv::OpDecorate && operands[1] == spv::DecorationRelaxedPrecision;
    if (relaxes) relaxed.push_back(operands[0]);
  });
  std::vector<std::string> found;
  for (const std::uint32_t id : relaxed) found.push_back(names[id]);
  return found;
}

std::vector<std::string> contractible(std::span<const std::uint32_t> words) {
  std::map<std::uint32_t, std::string> names;
  std::set<std::uint32_t> precise;
  std::set<std::uint32_t> powers_of_two;  // constants by which a float is multiplied without rounding
  std::vector<std::string> found;
  std::string function;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    if (operation == spv::OpName) names[operands[0]] = text_of(operands.subspan(1));
    const bool forbids = operation == spv::OpDecorate && operands[1] == spv::DecorationNoContraction;
    if (forbids) precise.insert(operands[0]);
    constexpr std::uint32_t kFractionBits = 0x007FFFFF;
    if (operation == spv::OpConstant && (operands[2] & kFractionBits) == 0) powers_of_two.insert(operands[1]);
    if (operation == spv::OpFunction) function = names[operands[1]];
    const bool scales = (operation == spv::OpFMul || operation == spv::OpVectorTimesScalar) &&
                        (powers_of_two.contains(operands[2]) || powers_of_two.contains(operands[3]));
    const bool free = rounds(operation) && !scales && !precise.contains(operands[1]);
    if (free && (found.empty() || found.back() != function)) found.push_back(function);
  });
  return found;
}

std::vector<std::uint32_t> spirv_of(std::string_view bytes) {
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

void forget_source_language(std::span<std::uint32_t> words) {
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    if (operation != spv::OpSource) return;
    words[static_cast<std::size_t>(operands.data() - words.data())] = spv::SourceLanguageUnknown;
  });
}

std::vector<std::uint32_t> without_repeated_decorations(std::span<const std::uint32_t> words) {
  std::vector<std::uint32_t> kept(words.begin(),
                                  words.begin() + static_cast<std::ptrdiff_t>(std::min(words.size(), kHeader)));
  std::set<std::vector<std::uint32_t>> seen;
  for_each_instruction(words, [&](spv::Op operation, std::span<const std::uint32_t> operands) {
    const bool decorates = operation == spv::OpDecorate || operation == spv::OpMemberDecorate;
    const std::vector<std::uint32_t> instruction(operands.data() - 1, operands.data() + operands.size());
    if (decorates && !seen.insert(instruction).second) return;
    kept.insert(kept.end(), instruction.begin(), instruction.end());
  });
  return kept;
}

}  // namespace hn

// Reads facts from a module of SPIR-V.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

// The module in the bytes of a file.
std::vector<std::uint32_t> spirv_of(std::string_view bytes);

// SPIRV-Tools' verdict, by the rules of the oldest Vulkan that has its version.
Result<void> validate_spirv(std::span<const std::uint32_t> words);

// The disassembly of a module; nothing if these bytes are none.
std::optional<std::string> spirv_text(std::string_view bytes);

// The instructions between OpFunction and OpFunctionEnd, without OpFunctionParameter and OpLabel, which do nothing.
std::int64_t count_spirv(std::span<const std::uint32_t> words);

// The results of instructions that may be computed in less than 32 bits: their names, where they have one, else "".
std::vector<std::string> relaxed_precision(std::span<const std::uint32_t> words);

// The functions in which an operation on floats may be contracted or reassociated with others: their mangled names.
std::vector<std::string> contractible(std::span<const std::uint32_t> words);

// It names the language of the text for debuggers, and a validator refuses one that is newer than itself.
void forget_source_language(std::span<std::uint32_t> words);

// The module without decorations that it has already: valid SPIR-V has each once.
std::vector<std::uint32_t> without_repeated_decorations(std::span<const std::uint32_t> words);

}  // namespace hn

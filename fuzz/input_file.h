#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "core/base/result.h"

namespace leitstand::fuzz {

/// A file in memory with the fuzzer's bytes, for readers that take a path. The file of the former input is
/// used again.
class InputFile {
public:
    InputFile(const std::uint8_t* data, std::size_t size);
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

/// Wants that @p error names its file @p name and can be read; 0, for the fuzzer.
int requireNamed(const Error& error, const char* name);

/// Ends the program, for the fuzzer to tell, when @p holds is false: what must hold whatever the input was.
void require(bool holds, const char* what);

}  // namespace leitstand::fuzz

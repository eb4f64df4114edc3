/// \file
/// Errors as values. Every fallible function of the core returns Expected<T>; nothing throws across a module.
///
/// The text is an English template with %1, %2 ... so that the interface can translate it (wrap literals in
/// RAMURE_NOOP, which lupdate reads under the context "core"); message() fills it in English for the CLI.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

/// Marks an English text of the core for translation under the context "core"; expands to the text.
#define RAMURE_NOOP(text) text

namespace ramure {

enum class ErrorCode : std::uint8_t {
    Invalid,   ///< a value or a structure that is not allowed
    Syntax,    ///< text that cannot be parsed
    Limit,     ///< a stated limit was reached (string length, file size ...)
    Io,        ///< the operating system refused: missing file, full disk, no permission
    Version,   ///< a file of a newer program
    Unknown,   ///< an unknown key, preset, file ending ...
    Cancelled, ///< the caller asked to stop
};

struct Error
{
    ErrorCode code = ErrorCode::Invalid;
    const char* text = "";         ///< English template, a RAMURE_NOOP literal
    std::vector<std::string> args; ///< replace %1, %2 ...
    std::string file;              ///< path of the file concerned, may be empty
    std::string path;              ///< path inside: a JSON path, a parameter key; may be empty
    int line = 0;                  ///< 1-based, 0 = none
    int column = 0;                ///< 1-based, counted in bytes, 0 = none

    /// The template with its arguments, without the place.
    [[nodiscard]] std::string plain() const;
    /// "file:line:column: path: text" with the parts that exist.
    [[nodiscard]] std::string message() const;
};

template <class T> using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, const char* text, std::vector<std::string> args = {})
{
    Error error;
    error.code = code;
    error.text = text;
    error.args = std::move(args);
    return tl::make_unexpected(std::move(error));
}

/// The error as it is, to hand on from a function with another value type.
inline tl::unexpected<Error> fail(Error error)
{
    return tl::make_unexpected(std::move(error));
}

} // namespace ramure

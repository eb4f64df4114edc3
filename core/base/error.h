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

/// Leaves the function with the error of an Expected that has no value: RAMURE_TRY(readCsv(path)); or, to go
/// on with the value, auto cells = readCsv(path); RAMURE_TRY(cells);
#define RAMURE_TRY(...) RAMURE_TRY_AS(RAMURE_TRY_NAME(__LINE__), __VA_ARGS__)
#define RAMURE_TRY_NAME(line) RAMURE_TRY_JOIN(tried, line)
#define RAMURE_TRY_JOIN(name, line) name##line
#define RAMURE_TRY_AS(name, ...)                                                                             \
    do {                                                                                                     \
        if (auto&& name = (__VA_ARGS__); !name)                                                              \
            return ::ramure::fail(std::move(name.error()));                                                  \
    } while (false)

inline tl::unexpected<Error> fail(ErrorCode code, const char* text, std::vector<std::string> args = {})
{
    Error error;
    error.code = code;
    error.text = text;
    error.args = std::move(args);
    return tl::make_unexpected(std::move(error));
}

/// The error as it is, to hand on from a function with another value type. \see RAMURE_TRY
inline tl::unexpected<Error> fail(Error error)
{
    return tl::make_unexpected(std::move(error));
}

} // namespace ramure

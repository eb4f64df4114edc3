/// \file
/// UTF-8: whether bytes are text, and characters as bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ramure {

/// Returns how many bytes the first character of \p text has (1 to 4), or 0 if \p text is empty or does not
/// begin with a character. Overlong forms, surrogates and numbers beyond Unicode are no characters.
inline std::size_t utf8Length(std::string_view text)
{
    const auto byte = [text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80)
        return text.empty() ? 0 : 1;
    const std::size_t length = first < 0xC2 || first > 0xF4 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80)
            return 0;
    const bool isForbidden = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                             (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
    return isForbidden ? 0 : length;
}

inline bool isUtf8(std::string_view text)
{
    while (const std::size_t length = utf8Length(text))
        text.remove_prefix(length);
    return text.empty();
}

/// \pre \p character is a character of Unicode: at most 0x10FFFF and no surrogate.
inline void appendUtf8(std::string& out, char32_t character)
{
    if (character < 0x80) {
        out += static_cast<char>(character);
        return;
    }
    const int following = character < 0x800 ? 1 : character < 0x10000 ? 2 : 3;
    constexpr unsigned heads[] = {0, 0xC0, 0xE0, 0xF0};
    out += static_cast<char>(heads[following] | (character >> (6 * following)));
    for (int shift = 6 * (following - 1); shift >= 0; shift -= 6)
        out += static_cast<char>(0x80 | ((character >> shift) & 0x3F));
}

} // namespace ramure

#include "core/generators/grammar/lookalikes.h"

#include <algorithm>
#include <array>
#include <span>

namespace ramure {
namespace {

struct Decoded
{
    char32_t code = 0;
    std::size_t size = 1; ///< 1 with a code of 0x80 or more: no valid UTF-8
};

Decoded decoded(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at);
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
    if (first < 0xC0 || first > 0xF4 || at + size > text.size())
        return {first, 1};
    char32_t code = first & (0xFFu >> (size + 1));
    for (std::size_t i = at + 1; i < at + size; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u)
            return {first, 1};
        code = (code << 6) | (byte(i) & 0x3Fu);
    }
    return {code, size};
}

struct Row
{
    std::u32string_view characters;
    const char* plain;
};

constexpr std::array notation{
    Row{U"\u2010\u2011\u2012\u2013\u2014\u2015\u2043\u2212\u2796\uFE58\uFE63", "-"},
    Row{U"\u2192\u21D2\u21A6\u27F6\u27F9\u2794\u279C", "->"},
    Row{U"\u00B7\u00D7\u204E\u2217\u22C5", "*"},
    Row{U"\u00F7\u2044\u2215", "/"},
    Row{U"\u2264\u2A7D", "<="},
    Row{U"\u2265\u2A7E", ">="},
    Row{U"\u2260", "!="},
    Row{U"\u2227", "&&"},
    Row{U"\u2228", "||"},
    Row{U"\u00AC", "!"},
    Row{U"\u02DC\u223C", "~"},
    Row{U"\u2223", "|"},
    Row{U"\u2236", ":"},
    Row{U"\u2795\uFE62", "+"},
    Row{U"\u00A0\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200A\u202F\u205F\u3000", " "},
    Row{U"\u00AD\u200B\u200C\u200D\u2060\uFEFF", ""},
};

/// Not the same as their plain forms, but easily taken for them. Quotes have no meaning in the language.
constexpr std::array others{
    Row{U"\u00B4\u2018\u2019\u201A\u201B\u201C\u201D\u201E\u201F\u2032\u2033\u00AB\u00BB", ""},
    Row{U"\u2039\u2329\u27E8\u3008", "<"},
    Row{U"\u203A\u232A\u27E9\u3009", ">"},
    Row{U"\u02C6\u2038\u2303", "^"},
    Row{U"\u2216\u29F5\uFE68", "\\"},
    Row{U"\u00A6\u01C0", "|"},
    Row{U"\u02CD", "_"},
    Row{U"\u2024", "."},
    Row{U"\u2772\u27E6\u3010\u3014", "["},
    Row{U"\u2773\u27E7\u3011\u3015", "]"},
};

/// Letters of Greek and Cyrillic, and the Latin ones that look the same.
constexpr std::u32string_view foreignLetters =
    U"\u0391\u0392\u0395\u0396\u0397\u0399\u039A\u039C\u039D\u039F\u03A1\u03A4\u03A5\u03A7\u03BF"
    U"\u0405\u0406\u0408\u0410\u0412\u0415\u041A\u041C\u041D\u041E\u0420\u0421\u0422\u0425"
    U"\u0430\u0435\u043E\u0440\u0441\u0443\u0445\u0455\u0456\u0458";
constexpr std::string_view latinLetters = "ABEZHIKMNOPTYXo"
                                          "SIJABEKMHOPCTX"
                                          "aeopcyxsij";
static_assert(foreignLetters.size() == latinLetters.size());

bool isSubscript(char32_t code)
{
    return code >= 0x2080 && code <= 0x2089;
}

/// Where the plain form is one character: full-width forms, letters and digits as formulas print them.
char plainCharacter(char32_t code)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    if (code >= 0xFF01 && code <= 0xFF5E)
        return static_cast<char>(code - 0xFF01 + '!');
    if (code >= 0x1D400 && code <= 0x1D6A3)
        return letters[(code - 0x1D400) % letters.size()];
    if (code >= 0x1D7CE && code <= 0x1D7FF)
        return static_cast<char>('0' + (code - 0x1D7CE) % 10);
    if (isSubscript(code))
        return static_cast<char>('0' + (code - 0x2080));
    const std::size_t letter = foreignLetters.find(code);
    return letter == std::u32string_view::npos ? '\0' : latinLetters[letter];
}

const Row* rowOf(std::span<const Row> rows, char32_t code)
{
    const auto found = std::ranges::find_if(
        rows, [code](const Row& row) { return row.characters.find(code) != std::u32string_view::npos; });
    return found == rows.end() ? nullptr : &*found;
}

} // namespace

std::optional<Lookalike> lookalikeAt(std::string_view text, std::size_t at)
{
    const auto [code, size] = decoded(text, at);
    if (size == 1)
        return std::nullopt;
    if (const Row* row = rowOf(notation, code))
        return Lookalike{size, row->plain, true};
    if (const Row* row = rowOf(others, code))
        return Lookalike{size, row->plain, false};
    if (const char plain = plainCharacter(code))
        return Lookalike{size, std::string(1, plain), isSubscript(code)};
    return std::nullopt;
}

std::size_t characterSize(std::string_view text, std::size_t at)
{
    return decoded(text, at).size;
}

std::string codePointName(std::string_view text, std::size_t at)
{
    constexpr const char* digits = "0123456789ABCDEF";
    const char32_t code = decoded(text, at).code;
    std::string name = "U+";
    for (int shift = code > 0xFFFF ? 16 : 12; shift >= 0; shift -= 4)
        name += digits[(code >> shift) & 15];
    return name;
}

std::string plainNotation(std::string_view text)
{
    std::string plain(text);
    for (std::size_t at = 0; at < text.size(); at += characterSize(text, at)) {
        const auto found = lookalikeAt(text, at);
        if (found && found->isNotation)
            plain.replace(at, found->size,
                          found->plain + std::string(found->size - found->plain.size(), ' '));
    }
    return plain;
}

} // namespace ramure

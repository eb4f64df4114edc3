#include "core/generators/grammar/grammar.h"

#include "core/generators/grammar/lookalikes.h"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace ramure {
namespace {

constexpr const char* axiomPath = "grammar.axiom";
constexpr const char* rulesPath = "grammar.rules";
constexpr char escapeSign = '`';

/// One symbol as it stands in the user's text.
struct Glyph
{
    char symbol;
    bool escaped;
    int line, column;

    [[nodiscard]] bool isMark(char mark) const { return !escaped && symbol == mark; }
};
using Glyphs = std::span<const Glyph>;

struct Place
{
    int line, column;
};

tl::unexpected<Error> failAt(const Place& place, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().line = place.line;
    error.value().column = place.column;
    return error;
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// For messages: the symbol itself, or its code where it cannot be seen.
std::string nameOf(char symbol)
{
    if (symbol > ' ' && symbol < '\x7f')
        return std::string(1, symbol);
    constexpr const char* digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(symbol);
    return std::string("0x") + digits[byte >> 4] + digits[byte & 15];
}

std::string textOf(Glyphs glyphs)
{
    std::string text(glyphs.size(), '\0');
    std::ranges::transform(glyphs, text.begin(), &Glyph::symbol);
    return text;
}

/// The line without its blanks, escapes resolved.
Expected<void> appendLine(std::string_view line, int number, std::vector<Glyph>& glyphs)
{
    for (std::size_t i = 0; i < line.size(); ++i) {
        const int column = static_cast<int>(i) + 1;
        if (isBlank(line[i]))
            continue;
        if (line[i] != escapeSign) {
            glyphs.push_back({line[i], false, number, column});
            continue;
        }
        if (++i == line.size())
            return failAt(
                {number, column}, ErrorCode::Syntax,
                RAMURE_NOOP("the backquote takes the next character as it is, but the line ends here"));
        glyphs.push_back({line[i], true, number, column});
    }
    return {};
}

/// Calls \p visit(line, number) for every line of the text until one fails.
template <class Visit> Expected<void> forEachLine(std::string_view text, Visit&& visit)
{
    for (int number = 1;; ++number) {
        const std::size_t end = text.find('\n');
        if (Expected<void> done = visit(text.substr(0, end), number); !done)
            return done;
        if (end == std::string_view::npos)
            return {};
        text.remove_prefix(end + 1);
    }
}

/// \param symbolAt, placeAt give the symbol and the place of each of \p count symbols.
template <class SymbolAt, class PlaceAt>
Expected<void> checkBrackets(std::size_t count, SymbolAt&& symbolAt, PlaceAt&& placeAt)
{
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < count; ++i) {
        if (symbolAt(i) == '[')
            open.push_back(i);
        if (symbolAt(i) != ']')
            continue;
        if (open.empty())
            return failAt(placeAt(i), ErrorCode::Invalid, RAMURE_NOOP("this \"]\" has no \"[\" before it"));
        open.pop_back();
    }
    if (!open.empty())
        return failAt(placeAt(open.back()), ErrorCode::Invalid, RAMURE_NOOP("this \"[\" is never closed"));
    return {};
}

Expected<void> checkBrackets(Glyphs glyphs)
{
    return checkBrackets(
        glyphs.size(), [&](std::size_t i) { return glyphs[i].symbol; },
        [&](std::size_t i) {
            return Place{glyphs[i].line, glyphs[i].column};
        });
}

/// What a symbol in ASCII is easily written for; quotes are none of the language.
std::optional<std::string> plainOf(char symbol)
{
    switch (symbol) {
    case '{':
        return "[";
    case '}':
        return "]";
    case '\'':
    case '"':
        return "";
    default:
        return std::nullopt;
    }
}

GrammarNote noteOn(const std::string& shown, const std::optional<std::string>& plain)
{
    const bool isNothing = plain && (plain->empty() || *plain == " ");
    const char* text = RAMURE_NOOP("%1 grows branches here and is not read as \"%2\": write \"%2\", or put a "
                                   "backquote in front of it to keep it");
    if (!plain)
        text = RAMURE_NOOP("%1 is read as several symbols, one per byte, and each of them grows a branch");
    else if (isNothing)
        text = RAMURE_NOOP("%1 grows branches here: remove it, or put a backquote in front of it to keep it");
    GrammarNote note;
    note.replacement = plain;
    note.what = fail(ErrorCode::Invalid, text, {shown, plain.value_or("")}).value();
    return note;
}

/// Remarks on a text; each is dropped in the end where a rule replaces its symbol.
class SymbolNotes
{
public:
    SymbolNotes(GrammarNotes& notes, const char* path)
        : m_notes(notes)
        , m_path(path)
    {
    }

    void add(GrammarNote note, const Place& place)
    {
        note.what.path = m_path;
        note.what.line = place.line;
        note.what.column = place.column;
        m_notes.push_back(std::move(note));
    }

    void read(Glyphs glyphs)
    {
        const std::string text = textOf(glyphs);
        for (std::size_t i = 0; i < text.size(); i += characterSize(text, i)) {
            if (glyphs[i].escaped)
                continue;
            const std::size_t size = characterSize(text, i);
            const bool isAscii = static_cast<unsigned char>(text[i]) < 0x80;
            std::optional<std::string> plain;
            if (isAscii)
                plain = plainOf(text[i]);
            else if (const auto found = lookalikeAt(text, i))
                plain = found->plain;
            if (!plain && size == 1)
                continue;
            GrammarNote note = noteOn(shownCharacter(text, i), plain);
            note.size = size;
            note.symbol = text[i];
            add(std::move(note), {glyphs[i].line, glyphs[i].column});
        }
    }

private:
    GrammarNotes& m_notes;
    const char* m_path;
};

/// Lines that other programs understand, and that are comments here.
std::optional<std::string> directiveOf(std::string_view line)
{
    const auto end = std::ranges::find_if(line.substr(1), [](char c) { return c < 'a' || c > 'z'; });
    const std::string word(line.begin(), end);
    const bool isKnown = word == "#define" || word == "#ignore" || word == "#consider" || word == "#include";
    return isKnown ? std::optional(word) : std::nullopt;
}

GrammarNote commentNote(const std::string& directive)
{
    GrammarNote note;
    note.size = directive.size();
    note.what =
        fail(ErrorCode::Invalid,
             RAMURE_NOOP("this line is a comment: %1 is only read in the language \"Modules with numbers\" "
                         "(grammar.dialect=parametric)"),
             {directive})
            .value();
    return note;
}

Expected<void> checkProbability(double probability, const Place& place)
{
    if (!std::isfinite(probability))
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("a probability must be a finite number"));
    if (probability < 0.0)
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("a probability cannot be negative"));
    return {};
}

Expected<void> checkSum(const std::vector<double>& probabilities, const Place& place)
{
    double sum = 0.0;
    for (const double probability : probabilities)
        sum += probability;
    if (!probabilities.empty() && sum <= 0.0)
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("all probabilities of the rule are zero"));
    if (!std::isfinite(sum))
        return failAt(place, ErrorCode::Invalid,
                      RAMURE_NOOP("the probabilities add up to more than a number holds"));
    return {};
}

/// Parses one line that is neither blank nor a comment.
class RuleParser
{
public:
    /// \param endColumn where a missing part is reported; \param brackets check them
    RuleParser(Glyphs line, int endColumn, bool brackets)
        : m_number(line[0].line)
        , m_line(line.subspan(labelOf(line)))
        , m_label(textOf(line.first(line.size() - m_line.size())))
        , m_endColumn(endColumn)
        , m_brackets(brackets)
    {
    }

    /// What stands behind the arrow; everything where there is none.
    [[nodiscard]] Glyphs rightSide() const { return m_line.subspan(m_right); }

    Expected<Rule> parse()
    {
        const bool startsWithArrow = arrowAt(0) > 0 && arrowAt(1) == 0;
        if (startsWithArrow)
            return failAt(placeAt(0), ErrorCode::Syntax, RAMURE_NOOP("there is no symbol before \"->\""));
        if (arrowAt(1) == 0)
            return noArrow();
        m_rule.symbol = m_line[0].symbol;
        m_right = 1 + arrowAt(1);
        const Glyphs right = rightSide();
        const bool hasChoices =
            std::ranges::any_of(right, [](const Glyph& g) { return g.isMark('|') || g.isMark(':'); });
        const Expected<void> done = hasChoices ? parseChoices() : takeText(right, m_rule.defaultText);
        RAMURE_TRY(done);
        return std::move(m_rule);
    }

private:
    /// Symbols of a name for the rule in front of it, "p1:", as books have them.
    static std::size_t labelOf(Glyphs line)
    {
        const auto end = std::ranges::find_if_not(line, [](const Glyph& glyph) {
            const char c = glyph.symbol;
            return !glyph.escaped &&
                   ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'));
        });
        const auto size = static_cast<std::size_t>(end - line.begin());
        return size > 1 && size < line.size() && end->isMark(':') ? size + 1 : 0;
    }

    /// How many symbols of an arrow stand there, "->" or a typographic one.
    [[nodiscard]] std::size_t arrowAt(std::size_t i) const
    {
        if (i + 1 < m_line.size() && m_line[i].isMark('-') && m_line[i + 1].isMark('>'))
            return 2;
        const auto found = characterAt(i);
        return found && found->plain == "->" ? found->size : 0;
    }
    [[nodiscard]] std::optional<Lookalike> characterAt(std::size_t i) const
    {
        return i < m_line.size() && !m_line[i].escaped ? lookalikeAt(textOf(m_line), i) : std::nullopt;
    }
    [[nodiscard]] Place placeAt(std::size_t i) const
    {
        return {m_number, i < m_line.size() ? m_line[i].column : m_endColumn};
    }

    [[nodiscard]] tl::unexpected<Error> noArrow() const
    {
        const std::size_t at = characterAt(0) ? 0 : 1;
        const Place place = placeAt(at);
        if (const auto found = characterAt(at)) {
            const Error error = lookalikeError(shownCharacter(textOf(m_line), at), found->plain);
            return failAt(place, error.code, error.text, error.args);
        }
        constexpr std::string_view ofModules = "(<>:";
        const bool isOfModules =
            at < m_line.size() && ofModules.find(m_line[at].symbol) != std::string_view::npos;
        if (isOfModules || m_label == "ignore:" || m_label == "consider:")
            return failAt(
                place, ErrorCode::Syntax,
                RAMURE_NOOP("numbers, contexts and conditions belong to the language \"Modules with "
                            "numbers\" (grammar.dialect=parametric)"));
        return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("\"->\" must follow the symbol %1"),
                      {m_line.empty() ? m_label : nameOf(m_line[0].symbol)});
    }

    Expected<void> takeText(Glyphs glyphs, std::string& text)
    {
        text = textOf(glyphs);
        return m_brackets ? checkBrackets(glyphs) : Expected<void>();
    }

    Expected<void> parseChoices()
    {
        for (std::size_t from = m_right; from <= m_line.size();) {
            std::size_t to = from;
            while (to < m_line.size() && !m_line[to].isMark('|'))
                ++to;
            if (auto done = parseChoice(from, to); !done)
                return done;
            from = to + 1;
        }
        if (!m_hasDefault && !m_rule.replacements.empty())
            m_rule.defaultText = m_rule.replacements.front();
        return checkSum(m_rule.probabilities, placeAt(m_right));
    }

    Expected<void> parseChoice(std::size_t from, std::size_t to)
    {
        const auto isColon = [](const Glyph& glyph) { return glyph.isMark(':'); };
        const Glyphs choice = m_line.subspan(from, to - from);
        const auto colon = std::ranges::find_if(choice, isColon);
        if (colon == choice.end())
            return failAt(placeAt(from), ErrorCode::Syntax,
                          RAMURE_NOOP("each choice needs a probability and a colon: \"0.5: text\""));
        const auto second = std::find_if(colon + 1, choice.end(), isColon);
        if (second != choice.end())
            return failAt({second->line, second->column}, ErrorCode::Syntax,
                          RAMURE_NOOP("a second colon; write `: for the symbol"));
        const std::string head = textOf({choice.begin(), colon});
        const Glyphs text(colon + 1, choice.end());
        return head == "default" ? takeDefault(text, placeAt(from)) : takeChoice(head, text, placeAt(from));
    }

    Expected<void> takeDefault(Glyphs text, const Place& place)
    {
        if (std::exchange(m_hasDefault, true))
            return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("the rule has two defaults"));
        return takeText(text, m_rule.defaultText);
    }

    Expected<void> takeChoice(const std::string& head, Glyphs text, const Place& place)
    {
        double probability = 0.0;
        const auto [end, status] = std::from_chars(head.data(), head.data() + head.size(), probability);
        if (status == std::errc::result_out_of_range)
            return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("the number %1 is out of all range"),
                          {head});
        if (status != std::errc() || end != head.data() + head.size())
            return failAt(place, ErrorCode::Syntax,
                          RAMURE_NOOP("\"%1\" is neither a probability nor \"default\""), {head});
        if (auto ok = checkProbability(probability, place); !ok)
            return ok;
        m_rule.probabilities.push_back(probability);
        return takeText(text, m_rule.replacements.emplace_back());
    }

    int m_number; ///< of the line
    Glyphs m_line;
    std::string m_label;
    std::size_t m_right = 0;
    int m_endColumn;
    bool m_brackets;
    bool m_hasDefault = false;
    Rule m_rule;
};

/// In which line each symbol got its rule, 0 = none.
using RuleLines = std::array<int, 256>;

Expected<void> claimSymbol(RuleLines& lines, char symbol, const Place& place)
{
    int& line = lines[static_cast<unsigned char>(symbol)];
    if (line != 0)
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("the symbol %1 already has a rule, in line %2"),
                      {nameOf(symbol), std::to_string(line)});
    line = place.line;
    return {};
}

Expected<std::vector<Rule>> readRules(std::string_view text, bool brackets, GrammarNotes& notes)
{
    SymbolNotes remarks(notes, rulesPath);
    std::vector<Rule> rules;
    std::vector<Glyph> glyphs;
    RuleLines ruleLines{};
    const auto done = forEachLine(text, [&](std::string_view line, int number) -> Expected<void> {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos)
            return {};
        if (line[first] == '#') {
            if (const auto word = directiveOf(line.substr(first)))
                remarks.add(commentNote(*word), {number, static_cast<int>(first) + 1});
            return {};
        }
        glyphs.clear();
        if (auto read = appendLine(line, number, glyphs); !read)
            return read;
        RuleParser parser(glyphs, static_cast<int>(line.size()) + 1, brackets);
        auto rule = parser.parse();
        remarks.read(parser.rightSide());
        RAMURE_TRY(rule);
        rules.push_back(std::move(*rule));
        return claimSymbol(ruleLines, rules.back().symbol, {number, glyphs.front().column});
    });
    RAMURE_TRY(done);
    return rules;
}

Expected<std::string> readAxiom(std::string_view text, bool brackets, GrammarNotes& notes)
{
    std::vector<Glyph> glyphs;
    auto done = forEachLine(
        text, [&](std::string_view line, int number) { return appendLine(line, number, glyphs); });
    SymbolNotes(notes, axiomPath).read(glyphs);
    if (done && brackets)
        done = checkBrackets(glyphs);
    RAMURE_TRY(done);
    return textOf(glyphs);
}

tl::unexpected<Error> withPath(Error error, const char* path)
{
    error.path = path;
    return fail(std::move(error));
}

/// A text of a grammar that was built in code.
Expected<void> checkText(const std::string& text, int line)
{
    const auto placeAt = [line](std::size_t i) { return Place{line, static_cast<int>(i) + 1}; };
    if (const std::size_t at = text.find('\n'); at != std::string::npos)
        return failAt(placeAt(at), ErrorCode::Invalid, RAMURE_NOOP("a line feed cannot be a symbol"));
    return checkBrackets(
        text.size(), [&](std::size_t i) { return text[i]; }, placeAt);
}

Expected<void> checkRule(const Rule& rule, int line)
{
    if (rule.symbol == '\n')
        return failAt({line, 0}, ErrorCode::Invalid, RAMURE_NOOP("a line feed cannot be a symbol"));
    if (rule.probabilities.size() != rule.replacements.size())
        return failAt({line, 0}, ErrorCode::Invalid,
                      RAMURE_NOOP("the rule for %1 has %2 probabilities for %3 replacements"),
                      {nameOf(rule.symbol), std::to_string(rule.probabilities.size()),
                       std::to_string(rule.replacements.size())});
    for (const double probability : rule.probabilities)
        if (auto ok = checkProbability(probability, {line, 0}); !ok)
            return ok;
    if (auto ok = checkSum(rule.probabilities, {line, 0}); !ok)
        return ok;
    for (const std::string& text : rule.replacements)
        if (auto ok = checkText(text, line); !ok)
            return ok;
    return checkText(rule.defaultText, line);
}

} // namespace

Expected<std::vector<Rule>> parseRules(std::string_view text)
{
    GrammarNotes notes;
    return readRules(text, false, notes);
}

Expected<std::string> parseAxiom(std::string_view text)
{
    GrammarNotes notes;
    return readAxiom(text, false, notes);
}

Expected<Grammar> parseGrammar(std::string_view axiom, std::string_view rules, GrammarNotes* notes)
{
    GrammarNotes found;
    auto readAxiomText = readAxiom(axiom, true, found);
    auto readRuleList = readRules(rules, true, found);
    if (notes) {
        // A symbol with a rule is meant as it stands.
        std::array<bool, 256> isReplaced{};
        for (const Rule& rule : readRuleList.value_or(std::vector<Rule>()))
            isReplaced[static_cast<unsigned char>(rule.symbol)] = true;
        std::erase_if(found, [&](const GrammarNote& note) {
            return isReplaced[static_cast<unsigned char>(note.symbol)];
        });
        *notes = std::move(found);
    }
    if (!readAxiomText)
        return withPath(std::move(readAxiomText.error()), axiomPath);
    if (!readRuleList)
        return withPath(std::move(readRuleList.error()), rulesPath);
    return Grammar{std::move(*readAxiomText), std::move(*readRuleList)};
}

Expected<void> checkGrammar(const Grammar& grammar)
{
    if (auto ok = checkText(grammar.axiom, 0); !ok)
        return withPath(std::move(ok.error()), axiomPath);
    RuleLines ruleLines{};
    int line = 0;
    for (const Rule& rule : grammar.rules) {
        auto ok = checkRule(rule, ++line);
        if (ok)
            ok = claimSymbol(ruleLines, rule.symbol, {line, 0});
        if (!ok)
            return withPath(std::move(ok.error()), rulesPath);
    }
    return {};
}

} // namespace ramure

#include "core/generators/parametric/parametric_grammar.h"

#include "core/generators/parametric/readable_text.h"
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace ramure {
namespace {

constexpr const char* axiomPath = "grammar.axiom";
constexpr const char* rulesPath = "grammar.rules";
constexpr const char* constantsPath = "grammar.constants";
constexpr std::array<std::string_view, 9> functions{"min", "max",  "abs",   "sqrt", "sin",
                                                    "cos", "rand", "order", "age"};

struct OrganName
{
    std::string_view name;
    OrganKind kind;
};
/// Flowers are a kind of fruit (core/params/fruit_params.h).
constexpr std::array organNames{OrganName{"leaf", OrganKind::Leaf}, OrganName{"fruit", OrganKind::Fruit},
                                OrganName{"flower", OrganKind::Fruit}};
constexpr const char* organList = "leaf, fruit, flower";

using Done = Expected<void>;

/// Calls \p visit(line, number) for every line of the text until one fails.
template <class Visit> Done forEachLine(std::string_view text, Visit&& visit)
{
    for (int number = 1;; ++number) {
        const std::size_t end = text.find('\n');
        if (Done done = visit(text.substr(0, end), number); !done)
            return done;
        if (end == std::string_view::npos)
            return {};
        text.remove_prefix(end + 1);
    }
}

Done checkNewName(std::string_view name, const TextPlace& place)
{
    if (name.empty())
        return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("a name is expected here"));
    if (std::ranges::find(functions, name) != functions.end())
        return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("\"%1\" has a meaning of its own already"),
                      {std::string(name)});
    return {};
}

/// Constants of a tree, line by line; a line may use those above it.
class ConstantReader
{
public:
    explicit ConstantReader(const GrammarParams& params)
        : m_params(params)
    {
    }

    /// "name = expression" or "#define name expression"
    Done read(TextScanner& text)
    {
        const bool isDefine = text.take("#define");
        const TextPlace place = text.place();
        const TextScanner before = text;
        const std::string name(text.takeName());
        if (auto done = checkNewName(name, place); !done)
            return done;
        if (m_constants.contains(name))
            return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("there is a constant \"%1\" already"),
                          {name});
        if (isDefine && before.peek(name.size()) == '(')
            return failAt(
                place, ErrorCode::Syntax,
                RAMURE_NOOP("macros with parameters are not supported: write \"%1\" out at each use"),
                {name});
        if (!text.take("=") && !isDefine)
            return failAt(text.place(), ErrorCode::Syntax, RAMURE_NOOP("\"=\" is expected here"));
        return readValue(text, name);
    }

    [[nodiscard]] Constants take() { return std::move(m_constants); }

private:
    Done readValue(TextScanner& text, const std::string& name)
    {
        ExpressionNames names;
        names.constants = &m_constants;
        const auto expression = parseExpression(text, names);
        RAMURE_TRY(expression);
        if (!text.atEnd())
            return failAt(text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("an operator or the end of the line is expected here"));
        ExpressionInputs inputs;
        inputs.byChance = m_params.stochastic;
        inputs.seed = static_cast<std::uint64_t>(m_params.seed);
        for (const char c : name) // of its own name: another constant in front changes nothing
            inputs.key = inputs.key * 131 + static_cast<unsigned char>(c);
        const double value = expression->value(inputs);
        if (!std::isfinite(value))
            return failAt(expression->place(), ErrorCode::Invalid,
                          RAMURE_NOOP("the result is not a finite number"));
        m_constants.emplace(name, value);
        return {};
    }

    const GrammarParams& m_params;
    Constants m_constants;
};

/// A line of the rules that is none in books and other programs, and where its value belongs here.
struct Elsewhere
{
    std::string_view word;
    const char* hint;
};
constexpr const char* axiomHint =
    RAMURE_NOOP("the axiom does not belong among the rules: write it under Axiom (grammar.axiom)");
constexpr std::array elsewhere{
    Elsewhere{"axiom", axiomHint},
    Elsewhere{"Axiom", axiomHint},
    Elsewhere{"ω", axiomHint},
    Elsewhere{
        "derivation",
        RAMURE_NOOP(
            "the number of steps does not belong among the rules: set Iterations (grammar.iterations)")},
};

class GrammarParser
{
public:
    explicit GrammarParser(const GrammarParams& params)
        : m_params(params)
    {
    }

    Expected<ParametricGrammar> parse()
    {
        auto constants = parseConstants(m_params);
        RAMURE_TRY(constants);
        m_made.constants = std::move(*constants);
        m_names.constants = &m_made.constants;
        const auto axiomText = readableText(m_params.axiom, axiomPath);
        RAMURE_TRY(axiomText);
        TextScanner axiom(*axiomText, axiomPath, 1, true);
        skipLabel(axiom, 1);
        RAMURE_TRY(readModules(axiom, m_made.axiom));
        if (!axiom.atEnd())
            return moduleExpected(axiom);
        const auto rulesText = readableText(m_params.rules, rulesPath);
        RAMURE_TRY(rulesText);
        const auto done = forEachLine(*rulesText, [this](std::string_view line, int number) -> Done {
            TextScanner text(line, rulesPath, number, false);
            return text.atEnd() || text.startsWith("#define") ? Done() : readLine(text);
        });
        RAMURE_TRY(done);
        for (const ParametricRule& rule : m_made.rules)
            m_made.of[static_cast<unsigned char>(rule.module.name)].push_back(&rule);
        m_made.usesOrder = m_names.usesOrder;
        return std::move(m_made);
    }

private:
    static tl::unexpected<Error> moduleExpected(const TextScanner& text)
    {
        switch (text.peek()) {
        case ':':
            return failAt(text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("a weight stands before its outcome: \"0.5: F | 0.5: FF\""));
        case '\'':
            return failAt(text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("tables of colours are not supported: leave ' out"));
        case '{':
        case '}':
        case '.':
            return failAt(
                text.place(), ErrorCode::Syntax,
                RAMURE_NOOP("polygons are not supported: write an organ such as ~(leaf, 0.1) instead"));
        default:
            return failAt(text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("a module is expected here: a letter, a digit or one of %1"),
                          {"+ - & ^ \\ / | $ ! % ~ [ ]"});
        }
    }

    /// "p1 :" in front of a rule, which has at least so many bytes, and means nothing. A word of one letter
    /// is a module with a condition.
    static void skipLabel(TextScanner& text, std::size_t leastBytes)
    {
        TextScanner after = text;
        if (after.takeName().size() >= leastBytes && after.take(":"))
            text = after;
    }

    Done readLine(TextScanner& text)
    {
        TextScanner after = text;
        const bool isCommand = after.take("#");
        const std::string_view word = after.takeName();
        if (word == "include" && isCommand)
            return failAt(text.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("files are not included: paste the text of the file here, or write an "
                                      "organ such as ~(leaf, 0.1) for a shape"));
        const bool hasColon = after.take(":");
        if ((word == "ignore" || word == "consider") && (isCommand || hasColon))
            return readIgnored(after, word == "ignore");
        const auto found = std::ranges::find(elsewhere, word, &Elsewhere::word);
        if (found != elsewhere.end())
            return failAt(text.place(), ErrorCode::Syntax, found->hint);
        skipLabel(text, 2);
        return readRule(text);
    }

    /// The letters of a line "ignore: +-" or "consider: F", which has nothing else.
    Done readIgnored(TextScanner& text, bool isIgnored)
    {
        if (!isIgnored)
            m_made.isIgnored.fill(true);
        while (!text.atEnd()) {
            if (text.take(","))
                continue;
            const char letter = text.peek();
            if (!isModuleLetter(letter) || letter == '[' || letter == ']')
                return moduleExpected(text);
            m_made.isIgnored[static_cast<unsigned char>(text.next())] = isIgnored;
        }
        return {};
    }

    Done readRule(TextScanner& text)
    {
        m_names.parameters.clear();
        m_names.randoms = 0;
        ParametricRule rule;
        if (auto done = readPatterns(text, rule); !done)
            return done;
        const bool hasCondition = text.take(":");
        if (hasCondition && !text.take("*")) {
            auto condition = parseExpression(text, m_names);
            RAMURE_TRY(condition);
            rule.condition = std::move(*condition);
        }
        if (!text.takeArrow())
            return failAt(text.place(), ErrorCode::Syntax,
                          !hasCondition
                              ? RAMURE_NOOP("\"->\", \":\", \"<\" or \">\" is expected here: a module or a "
                                            "context is one letter, and its names stand in brackets")
                              : RAMURE_NOOP("an operator or \"->\" is expected here"));
        if (auto done = readOutcomes(text, rule); !done)
            return done;
        m_made.usesContext = m_made.usesContext || rule.left || rule.right;
        m_made.usesChance = m_made.usesChance || rule.productions.size() > 1 || m_names.randoms > 0;
        m_made.rules.push_back(std::move(rule));
        return {};
    }

    /// The parameters of the module come first, then those of its contexts.
    Done readPatterns(TextScanner& text, ParametricRule& rule)
    {
        std::vector<std::string> leftNames, ownNames;
        takeAnyLeft(text);
        if (auto done = readPattern(text, rule.module); !done)
            return done;
        if (text.take("<")) {
            rule.left = rule.module;
            leftNames = std::exchange(m_names.parameters, {});
            if (auto done = readPattern(text, rule.module); !done)
                return done;
        }
        ownNames = std::exchange(m_names.parameters, {});
        if (text.take(">") && !text.take("*")) {
            rule.right.emplace();
            if (auto done = readPattern(text, *rule.right); !done)
                return done;
        }
        const TextPlace end = text.place();
        ownNames.insert(ownNames.end(), leftNames.begin(), leftNames.end());
        m_names.parameters.insert(m_names.parameters.begin(), ownNames.begin(), ownNames.end());
        auto sorted = m_names.parameters;
        std::ranges::sort(sorted);
        const auto twice = std::ranges::adjacent_find(sorted);
        if (twice != sorted.end())
            return failAt(end, ErrorCode::Syntax, RAMURE_NOOP("the rule has two parameters \"%1\""),
                          {*twice});
        return {};
    }

    /// "* <": any context will do.
    static void takeAnyLeft(TextScanner& text)
    {
        TextScanner after = text;
        if (after.take("*") && after.take("<"))
            text = after;
    }

    Done readPattern(TextScanner& text, ModulePattern& pattern)
    {
        const TextPlace place = text.place();
        if (!isModuleLetter(text.peek()) || text.atArrow())
            return moduleExpected(text);
        pattern = {text.next(), 0};
        if (pattern.name == '[' || pattern.name == ']')
            return failAt(place, ErrorCode::Invalid,
                          RAMURE_NOOP("brackets are neither replaced nor a context"));
        if (!text.take("("))
            return {};
        do {
            const TextPlace at = text.place();
            const std::string name(text.takeName());
            if (auto done = checkNewName(name, at); !done)
                return done;
            m_names.parameters.push_back(name);
            ++pattern.numbers;
        } while (text.take(","));
        if (pattern.numbers > mostModuleNumbers)
            return tooManyNumbers(place);
        return text.take(")")
                   ? Done()
                   : failAt(text.place(), ErrorCode::Syntax, RAMURE_NOOP("\",\" or \")\" is expected here"));
    }

    static tl::unexpected<Error> tooManyNumbers(const TextPlace& place)
    {
        return failAt(place, ErrorCode::Limit, RAMURE_NOOP("a module has at most %1 numbers"),
                      {std::to_string(mostModuleNumbers)});
    }

    Done readOutcomes(TextScanner& text, ParametricRule& rule)
    {
        const TextPlace start = text.place();
        if (!atWeight(text)) {
            if (auto done = readModules(text, rule.productions.emplace_back()); !done)
                return done;
            return text.atEnd() ? Done() : moduleExpected(text);
        }
        rule.weights = 0.0;
        do {
            Production& outcome = rule.productions.emplace_back();
            if (!text.atNumber())
                return failAt(text.place(), ErrorCode::Syntax,
                              RAMURE_NOOP("each outcome needs a weight and a colon: \"0.5: F\""));
            const auto weight = text.takeNumber();
            RAMURE_TRY(weight);
            outcome.weight = *weight;
            rule.weights += *weight;
            if (!text.take(":"))
                return failAt(text.place(), ErrorCode::Syntax, RAMURE_NOOP("\":\" is expected here"));
            if (auto done = readModules(text, outcome); !done)
                return done;
        } while (text.take("|"));
        if (!text.atEnd())
            return moduleExpected(text);
        if (!(rule.weights > 0.0) || !std::isfinite(rule.weights))
            return failAt(start, ErrorCode::Invalid,
                          RAMURE_NOOP("the weights must add up to more than 0, and to a finite number"));
        const auto heaviest = std::ranges::max_element(rule.productions, {}, &Production::weight);
        rule.likeliest = static_cast<std::size_t>(heaviest - rule.productions.begin());
        return {};
    }

    /// A number in front of a colon; digits without one are modules.
    static bool atWeight(const TextScanner& text)
    {
        TextScanner after = text;
        const std::size_t digits = text.digits();
        return text.atNumber() && after.takeNumber() && (after.startsWith(":") || text.peek(digits) == '.');
    }

    /// A bar in front of a weight parts two outcomes.
    static bool atBetweenOutcomes(const TextScanner& text)
    {
        TextScanner after = text;
        return after.take("|") && atWeight(after);
    }

    /// Up to what is no module.
    Done readModules(TextScanner& text, Production& out)
    {
        std::vector<TextPlace> open;
        while (isModuleLetter(text.peek()) && !atBetweenOutcomes(text)) {
            const TextPlace place = text.place();
            if (text.atArrow())
                return moduleExpected(text);
            if (text.peek() == '[')
                open.push_back(place);
            if (text.peek() == ']') {
                if (open.empty())
                    return failAt(place, ErrorCode::Invalid,
                                  RAMURE_NOOP("this \"]\" has no \"[\" before it"));
                open.pop_back();
            }
            if (auto done = readModule(text, out); !done)
                return done;
        }
        if (open.empty())
            return {};
        if (!text.atEnd() && !text.startsWith("|"))
            return moduleExpected(text);
        return failAt(open.back(), ErrorCode::Invalid, RAMURE_NOOP("this \"[\" is never closed"));
    }

    Done readModule(TextScanner& text, Production& out)
    {
        const TextPlace place = text.place();
        const char name = text.next();
        if (m_made.sources.size() == mostSources)
            return failAt(place, ErrorCode::Limit, RAMURE_NOOP("axiom and rules have more than %1 modules"),
                          {std::to_string(mostSources)});
        const auto first = static_cast<std::uint32_t>(out.numbers.size());
        out.modules.push_back({first, static_cast<std::uint16_t>(m_made.sources.size()), 0, name});
        const bool hasNumbers = name != '[' && name != ']' && text.take("(");
        std::optional<OrganKind> organ;
        if (hasNumbers && name == '~')
            if (auto done = readOrgan(text, organ); !done)
                return done;
        if (hasNumbers) {
            for (bool more = !organ || text.take(","); more; more = text.take(","))
                if (auto done = readNumber(text, out); !done)
                    return done;
            if (!text.take(")"))
                return failAt(text.place(), ErrorCode::Syntax,
                              RAMURE_NOOP("an operator, \",\" or \")\" is expected here"));
        }
        const std::size_t numbers = out.numbers.size() - first;
        if (numbers > mostModuleNumbers)
            return tooManyNumbers(place);
        m_made.sources.push_back({name, static_cast<std::uint8_t>(numbers), organ, place});
        return {};
    }

    /// The kind of an organ is a word, its size the first number.
    static Done readOrgan(TextScanner& text, std::optional<OrganKind>& organ)
    {
        const TextPlace place = text.place();
        const std::string_view name = text.takeName();
        const auto found = std::ranges::find(organNames, name, &OrganName::name);
        if (found == organNames.end())
            return name.empty()
                       ? failAt(place, ErrorCode::Syntax,
                                RAMURE_NOOP("the name of an organ is expected here: %1"), {organList})
                       : failAt(place, ErrorCode::Unknown,
                                RAMURE_NOOP("there is no organ \"%1\"; there are %2"),
                                {std::string(name), organList});
        organ = found->kind;
        return {};
    }

    Done readNumber(TextScanner& text, Production& out)
    {
        auto expression = parseExpression(text, m_names);
        RAMURE_TRY(expression);
        const auto at = static_cast<std::uint32_t>(out.numbers.size());
        const bool isConstant = expression->isConstant();
        out.numbers.push_back(isConstant ? expression->value({}) : 0.0);
        if (!isConstant)
            out.computed.push_back({at, std::move(*expression)});
        return {};
    }

    const GrammarParams& m_params;
    ParametricGrammar m_made;
    ExpressionNames m_names;
};

} // namespace

bool isModuleLetter(char letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') ||
           (letter != '\0' && std::string_view("+-&^\\/|$!%~[]").find(letter) != std::string_view::npos);
}

Expected<Constants> parseConstants(const GrammarParams& params)
{
    ConstantReader reader(params);
    const auto read = [&reader](const std::string& given, const char* path, bool isRules) {
        return readableText(given, path).and_then([&](const std::string& readable) {
            return forEachLine(readable, [&](std::string_view line, int number) -> Done {
                TextScanner text(line, path, number, false);
                const bool isOne = isRules ? text.startsWith("#define") : !text.atEnd();
                return isOne ? reader.read(text) : Done();
            });
        });
    };
    const auto done = read(params.constants, constantsPath, false).and_then([&] {
        return read(params.rules, rulesPath, true);
    });
    RAMURE_TRY(done);
    return reader.take();
}

Expected<ParametricGrammar> parseParametric(const GrammarParams& params)
{
    return GrammarParser(params).parse();
}

} // namespace ramure

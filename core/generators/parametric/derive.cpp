#include "core/generators/parametric/derive.h"

#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/math/random.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Modules between two looks at the stop token.
constexpr std::size_t modulesAtATime = std::size_t(1) << 16;
constexpr std::uint64_t keyStep = 0x9E3779B97F4A7C15ull;

std::uint64_t keyBelow(std::uint64_t parent, std::size_t number)
{
    return mixBits(parent + keyStep * (std::uint64_t(number) + 1));
}

/// The neighbours of every module along the branches; noIndex: none.
struct Contexts
{
    std::vector<Index> left, right;

    /// \param ignored letters that are nobody's neighbour
    Contexts(const std::vector<Module>& modules, const std::array<bool, 128>& ignored)
        : left(modules.size(), noIndex)
        , right(modules.size(), noIndex)
        , m_ignored(ignored)
    {
        std::vector<Index> levels{noIndex};
        for (std::size_t i = 0; i < modules.size(); ++i)
            step(modules[i].name, '[', ']', static_cast<Index>(i), true, left, levels);
        levels.assign(1, noIndex);
        for (std::size_t i = modules.size(); i-- > 0;)
            step(modules[i].name, ']', '[', static_cast<Index>(i), false, right, levels);
    }

private:
    /// \param inherits a branch begins with the neighbour of its bracket; without, with none.
    void step(char name, char open, char close, Index i, bool inherits, std::vector<Index>& found,
              std::vector<Index>& levels) const
    {
        if (name == open) {
            levels.push_back(inherits ? levels.back() : noIndex);
        } else if (name == close) {
            levels.pop_back();
        } else {
            found[i] = levels.back();
            if (!m_ignored[static_cast<unsigned char>(name)])
                levels.back() = i;
        }
    }

    const std::array<bool, 128>& m_ignored;
};

class Round
{
public:
    Round(const ParametricGrammar& grammar, const DeriveOptions& options, int number)
        : m_grammar(grammar)
        , m_options(options)
        , m_number(number)
    {
        m_inputs.byChance = options.stochastic;
        m_inputs.seed = options.seed;
        for (std::size_t i = 0; i < m_isSpecial.size(); ++i)
            m_isSpecial[i] = !grammar.of[i].empty();
        m_isSpecial['['] = m_isSpecial[']'] = grammar.usesOrder;
        m_isSpecial['%'] = true;
    }

    Expected<void> run(const ModuleWord& in, ModuleWord& out, const Progress& progress)
    {
        m_in = &in;
        m_out = &out;
        out.modules.clear();
        out.numbers.clear();
        out.keys.clear();
        if (m_grammar.usesContext)
            m_contexts.emplace(in.modules, m_grammar.isIgnored);
        std::size_t looked = 0;
        for (std::size_t i = 0; i < in.modules.size();) {
            if (i >= looked + modulesAtATime) {
                looked = i;
                if (progress.cancelled())
                    return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
                progress.report(static_cast<double>(i) / static_cast<double>(in.modules.size()));
            }
            const char name = in.modules[i].name;
            if (!special(name)) {
                const std::size_t end = endOfRun(i);
                if (auto done = keep(i, end); !done)
                    return done;
                i = end;
                continue;
            }
            m_inputs.order += (name == '[') - (name == ']');
            if (auto done = replace(i); !done)
                return done;
            i = name == '%' && m_grammar.of['%'].empty() ? endOfBranch(i + 1) : i + 1;
        }
        return {};
    }

private:
    [[nodiscard]] bool special(char name) const { return m_isSpecial[static_cast<unsigned char>(name)]; }

    /// What stays as it is up to there, for as long as it takes between two looks.
    [[nodiscard]] std::size_t endOfRun(std::size_t from) const
    {
        const std::size_t most = std::min(from + modulesAtATime, m_in->modules.size());
        std::size_t i = from + 1;
        while (i < most && !special(m_in->modules[i].name))
            ++i;
        return i;
    }

    [[nodiscard]] std::size_t endOfBranch(std::size_t i) const
    {
        for (int depth = 0; i < m_in->modules.size(); ++i) {
            const char name = m_in->modules[i].name;
            depth += (name == '[') - (name == ']');
            if (depth < 0)
                break;
        }
        return i;
    }

    [[nodiscard]] Expected<void> checkRoom(std::size_t modules, std::size_t numbers) const
    {
        if (m_out->modules.size() + modules <= m_options.limit &&
            m_out->numbers.size() + numbers <= 2 * m_options.limit)
            return {};
        return fail(ErrorCode::Limit, RAMURE_NOOP("iteration %1 would make more than %2 modules"),
                    {std::to_string(m_number), std::to_string(m_options.limit)});
    }

    Expected<void> keep(std::size_t from, std::size_t to)
    {
        const auto& modules = m_in->modules;
        const std::uint32_t first = modules[from].firstNumber;
        const std::size_t last = modules[to - 1].firstNumber + m_in->numbersOf(modules[to - 1]);
        if (auto ok = checkRoom(to - from, last - first); !ok)
            return ok;
        const auto shift = static_cast<std::uint32_t>(m_out->numbers.size()) - first;
        const std::size_t at = m_out->modules.size();
        m_out->modules.insert(m_out->modules.end(), modules.begin() + std::ptrdiff_t(from),
                              modules.begin() + std::ptrdiff_t(to));
        for (std::size_t i = at; i < m_out->modules.size(); ++i)
            m_out->modules[i].firstNumber += shift;
        m_out->numbers.insert(m_out->numbers.end(), m_in->numbers.begin() + std::ptrdiff_t(first),
                              m_in->numbers.begin() + std::ptrdiff_t(last));
        if (!m_in->keys.empty())
            m_out->keys.insert(m_out->keys.end(), m_in->keys.begin() + std::ptrdiff_t(from),
                               m_in->keys.begin() + std::ptrdiff_t(to));
        return {};
    }

    Expected<void> replace(std::size_t i)
    {
        const Module& module = m_in->modules[i];
        m_inputs.age = m_number - 1 - module.birth;
        // Of the round too: a module that stayed may have other luck in the next one.
        const std::uint64_t key = m_in->keys.empty() ? 0 : m_in->keys[i];
        m_inputs.key = mixBits(key ^ (keyStep * static_cast<std::uint64_t>(m_number)));
        for (const ParametricRule* rule : m_grammar.of[static_cast<unsigned char>(module.name)]) {
            if (!fits(*rule, i))
                continue;
            double holds = 1.0;
            if (!rule->condition.empty())
                holds = rule->condition.value(m_inputs);
            if (!std::isfinite(holds))
                return notFinite(rule->condition, module);
            if (holds != 0.0)
                return append(chosen(*rule), module, key);
        }
        return keep(i, i + 1);
    }

    bool fits(const ParametricRule& rule, std::size_t i)
    {
        const Module& module = m_in->modules[i];
        m_inputs.parameters = m_in->numbers.data() + module.firstNumber;
        if (m_in->numbersOf(module) != rule.module.numbers)
            return false;
        if (!rule.left && !rule.right)
            return true;
        double* end = std::copy_n(m_inputs.parameters, rule.module.numbers, m_gathered.data());
        m_inputs.parameters = m_gathered.data();
        return fits(rule.left, m_contexts->left[i], end) && fits(rule.right, m_contexts->right[i], end);
    }
    bool fits(const std::optional<ModulePattern>& pattern, Index at, double*& end) const
    {
        if (!pattern)
            return true;
        if (at == noIndex)
            return false;
        const Module& module = m_in->modules[at];
        if (module.name != pattern->name || m_in->numbersOf(module) != pattern->numbers)
            return false;
        end = std::copy_n(m_in->numbers.data() + module.firstNumber, pattern->numbers, end);
        return true;
    }

    [[nodiscard]] const Production& chosen(const ParametricRule& rule) const
    {
        if (!m_options.stochastic || rule.productions.size() == 1)
            return rule.productions[rule.likeliest];
        double left = Random(m_options.seed, RandomStream::Rewrite, m_inputs.key).unit() * rule.weights;
        for (const Production& production : rule.productions) {
            if (left < production.weight)
                return production;
            left -= production.weight;
        }
        return rule.productions[rule.likeliest];
    }

    Expected<void> append(const Production& production, const Module& from, std::uint64_t key)
    {
        if (auto ok = checkRoom(production.modules.size(), production.numbers.size()); !ok)
            return ok;
        const std::size_t at = m_out->modules.size(), first = m_out->numbers.size();
        m_out->modules.insert(m_out->modules.end(), production.modules.begin(), production.modules.end());
        for (std::size_t i = at; i < m_out->modules.size(); ++i) {
            m_out->modules[i].firstNumber += static_cast<std::uint32_t>(first);
            m_out->modules[i].birth = static_cast<std::uint8_t>(m_number);
        }
        m_out->numbers.insert(m_out->numbers.end(), production.numbers.begin(), production.numbers.end());
        for (const Production::Computed& each : production.computed) {
            const double value = each.expression.value(m_inputs);
            if (!std::isfinite(value))
                return notFinite(each.expression, from);
            m_out->numbers[first + each.number] = value;
        }
        if (!m_in->keys.empty())
            for (std::size_t i = 0; i < production.modules.size(); ++i)
                m_out->keys.push_back(keyBelow(key, i));
        return {};
    }

    [[nodiscard]] tl::unexpected<Error> notFinite(const Expression& expression, const Module& module) const
    {
        return failAt(expression.place(), ErrorCode::Invalid,
                      RAMURE_NOOP("this is not a finite number for %1 in iteration %2"),
                      {m_in->text(module), std::to_string(m_number)});
    }

    const ParametricGrammar& m_grammar;
    const DeriveOptions& m_options;
    int m_number;
    const ModuleWord* m_in = nullptr;
    ModuleWord* m_out = nullptr;
    std::optional<Contexts> m_contexts;
    ExpressionInputs m_inputs;
    std::array<bool, 128> m_isSpecial{};
    std::array<double, 3 * mostModuleNumbers> m_gathered{};
};

Expected<ModuleWord> axiomOf(const ParametricGrammar& grammar, const DeriveOptions& options)
{
    ModuleWord word;
    word.sources = grammar.sources;
    word.modules = grammar.axiom.modules;
    word.numbers = grammar.axiom.numbers;
    ExpressionInputs inputs;
    inputs.byChance = options.stochastic;
    inputs.seed = options.seed;
    for (const Production::Computed& each : grammar.axiom.computed) {
        word.numbers[each.number] = each.expression.value(inputs);
        if (!std::isfinite(word.numbers[each.number]))
            return failAt(each.expression.place(), ErrorCode::Invalid,
                          RAMURE_NOOP("the result is not a finite number"));
    }
    if (options.stochastic && grammar.usesChance)
        for (std::size_t i = 0; i < word.modules.size(); ++i)
            word.keys.push_back(keyBelow(0, i));
    return word;
}

} // namespace

std::string ModuleWord::text(const Module& module) const
{
    std::string out(1, module.name);
    for (std::size_t i = 0; i < numbersOf(module); ++i)
        out += (i == 0 ? "(" : ", ") + numberText(numbers[module.firstNumber + i]);
    return numbersOf(module) > 0 ? out + ")" : out;
}

Expected<ModuleWord> derive(const ParametricGrammar& grammar, const DeriveOptions& options,
                            const Progress& progress)
{
    auto word = axiomOf(grammar, options);
    ModuleWord next;
    if (word)
        next.sources = word->sources;
    for (int number = 1; word && number <= options.iterations; ++number) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const double all = options.iterations;
        RAMURE_TRY(Round(grammar, options, number)
                       .run(*word, next, progress.part((number - 1) / all, number / all)));
        std::swap(*word, next);
    }
    return word;
}

std::string lettersOf(const ModuleWord& word)
{
    std::string letters(word.modules.size(), '\0');
    std::ranges::transform(word.modules, letters.begin(), &Module::name);
    return letters;
}

} // namespace ramure

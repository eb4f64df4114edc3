#include "core/generators/grammar/rewrite.h"

#include "core/math/random.h"
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <vector>

namespace ramure {
namespace {

/// Texts are copied in blocks of this size; their storage and the output buffer are padded accordingly.
constexpr std::size_t block = 16;
/// Far above what memory holds, low enough that counting never overflows.
constexpr std::size_t hardLimit = std::size_t(1) << 32;
/// Symbols between two looks at the stop token.
constexpr std::size_t symbolsAtATime = std::size_t(1) << 20;

using Counts = std::array<std::uint64_t, 256>;

unsigned char byteOf(char symbol)
{
    return static_cast<unsigned char>(symbol);
}

/// A replacement whose storage may be read up to the next multiple of `block`.
struct PaddedText
{
    const char* data = nullptr;
    std::size_t size = 0;
};

/// What a symbol becomes. A symbol without a rule becomes itself.
struct Replacement
{
    PaddedText text;         ///< the default
    std::uint32_t from = 0;  ///< first of its choices
    std::uint32_t count = 0; ///< number of choices, 0 = always the default
};

struct Choice
{
    double upTo; ///< sum of the probabilities up to this one
    PaddedText text;
};

class Rewriter
{
public:
    Rewriter(const Grammar& grammar, bool stochastic)
    {
        for (std::size_t i = 0; i < 256; ++i) {
            const char symbol = static_cast<char>(i);
            m_table[i].text = store(std::string_view(&symbol, 1));
        }
        for (const Rule& rule : grammar.rules) {
            Replacement& replacement = m_table[byteOf(rule.symbol)];
            replacement.text = store(rule.defaultText);
            m_isIdentity = m_isIdentity && rule.defaultText == std::string_view(&rule.symbol, 1);
            if (stochastic && !rule.probabilities.empty())
                addChoices(rule, replacement);
        }
    }

    [[nodiscard]] bool hasChoices() const { return !m_choices.empty(); }
    /// Every symbol becomes itself.
    [[nodiscard]] bool isIdentity() const { return m_isIdentity && !hasChoices(); }

    /// The symbols of the next generation, counted, where no choice is involved.
    [[nodiscard]] Counts next(const Counts& counts) const
    {
        Counts result{};
        for (std::size_t symbol = 0; symbol < 256; ++symbol)
            if (counts[symbol] != 0)
                for (std::size_t i = 0; i < m_table[symbol].text.size; ++i)
                    result[byteOf(m_table[symbol].text.data[i])] += counts[symbol];
        return result;
    }

    /// Length of the next generation with the choices that \p random makes; stops counting above \p limit.
    [[nodiscard]] std::size_t measure(std::string_view in, Random random, std::size_t limit) const
    {
        std::size_t size = 0;
        for (const char symbol : in) {
            size += pick(symbol, random).size;
            if (size > limit)
                break;
        }
        return size;
    }

    /// Writes the next generation; returns its end.
    char* expand(std::string_view in, char* out) const
    {
        for (const char symbol : in)
            out = append(m_table[byteOf(symbol)].text, out);
        return out;
    }
    char* expand(std::string_view in, char* out, Random& random) const
    {
        for (const char symbol : in)
            out = append(pick(symbol, random), out);
        return out;
    }

private:
    /// One block at least: for the short texts that most symbols have there is no unforeseeable jump.
    static char* append(const PaddedText& text, char* out)
    {
        std::memcpy(out, text.data, block);
        for (std::size_t i = block; i < text.size; i += block)
            std::memcpy(out + i, text.data + i, block);
        return out + text.size;
    }

    const PaddedText& pick(char symbol, Random& random) const
    {
        const Replacement& replacement = m_table[byteOf(symbol)];
        if (replacement.count == 0)
            return replacement.text;
        const Choice* choice = &m_choices[replacement.from];
        const Choice* last = choice + replacement.count - 1;
        const double drawn = random.unit() * last->upTo;
        while (choice != last && drawn >= choice->upTo)
            ++choice;
        return choice->text;
    }

    PaddedText store(std::string_view text)
    {
        const std::size_t padded = (text.size() / block + 1) * block;
        m_storage.push_back(std::make_unique<char[]>(padded));
        std::copy(text.begin(), text.end(), m_storage.back().get());
        return {m_storage.back().get(), text.size()};
    }

    void addChoices(const Rule& rule, Replacement& replacement)
    {
        replacement.from = static_cast<std::uint32_t>(m_choices.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.probabilities.size(); ++i) {
            // What can never be drawn is left out, so that rounding cannot draw it either.
            if (rule.probabilities[i] > 0.0)
                m_choices.push_back({sum += rule.probabilities[i], store(rule.replacements[i])});
        }
        replacement.count = static_cast<std::uint32_t>(m_choices.size()) - replacement.from;
    }

    std::array<Replacement, 256> m_table;
    std::vector<Choice> m_choices;
    std::vector<std::unique_ptr<char[]>> m_storage;
    bool m_isIdentity = true;
};

tl::unexpected<Error> tooLong(int iteration, const RewriteOptions& options)
{
    return fail(
        ErrorCode::Limit,
        RAMURE_NOOP(
            "iteration %1 of %2 would make more than %3 symbols; use fewer iterations or shorter rules"),
        {std::to_string(iteration), std::to_string(options.iterations), std::to_string(options.limit)});
}

std::uint64_t sum(const Counts& counts)
{
    std::uint64_t total = 0;
    for (const std::uint64_t count : counts)
        total += count;
    return total;
}

/// Without choices the lengths of all generations follow from the counts of the symbols: a grammar that
/// explodes is refused before the first generation is written. Returns the largest length.
Expected<std::size_t> predictLargest(const Rewriter& rewriter, std::string_view axiom,
                                     const RewriteOptions& options)
{
    Counts counts{};
    for (const char symbol : axiom)
        ++counts[byteOf(symbol)];
    std::uint64_t largest = sum(counts);
    for (int iteration = 1; iteration <= options.iterations; ++iteration) {
        const Counts next = rewriter.next(counts);
        largest = std::max(largest, sum(next));
        if (largest > options.limit)
            return tooLong(iteration, options);
        if (next == counts)
            break;
        counts = next;
    }
    return static_cast<std::size_t>(largest);
}

/// Two buffers that change places from generation to generation and grow when they must.
struct Buffer
{
    std::unique_ptr<char[]> data;
    std::size_t capacity = 0;
    std::size_t size = 0;

    void reserve(std::size_t symbols)
    {
        if (symbols + block <= capacity)
            return;
        capacity = symbols + block;
        data = std::make_unique_for_overwrite<char[]>(capacity);
    }
    [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// Calls \p expandPart on the input in strides. False = cancelled.
template <class Expand>
bool expandAll(std::string_view in, Buffer& out, const Progress& progress, Expand&& expandPart)
{
    char* end = out.data.get();
    for (std::size_t from = 0; from < in.size(); from += symbolsAtATime) {
        if (progress.cancelled())
            return false;
        end = expandPart(in.substr(from, symbolsAtATime), end);
    }
    out.size = static_cast<std::size_t>(end - out.data.get());
    return true;
}

Expected<void> rewriteOnce(const Rewriter& rewriter, const Buffer& in, Buffer& out, int iteration,
                           const RewriteOptions& options, const Progress& progress)
{
    bool done = true;
    if (rewriter.hasChoices()) {
        Random random(options.seed, RandomStream::Rewrite, static_cast<std::uint64_t>(iteration));
        const std::size_t size = rewriter.measure(in.view(), random, options.limit);
        if (size > options.limit)
            return tooLong(iteration, options);
        out.reserve(size);
        done = expandAll(in.view(), out, progress,
                         [&](std::string_view part, char* to) { return rewriter.expand(part, to, random); });
    } else {
        done = expandAll(in.view(), out, progress,
                         [&](std::string_view part, char* to) { return rewriter.expand(part, to); });
    }
    if (!done || progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    return {};
}

} // namespace

Expected<std::string> rewrite(const Grammar& grammar, const RewriteOptions& given, const Progress& progress)
{
    RewriteOptions options = given;
    options.limit = std::min(options.limit, hardLimit);
    RAMURE_TRY(checkGrammar(grammar));
    if (grammar.axiom.size() > options.limit)
        return tooLong(0, options);
    const Rewriter rewriter(grammar, options.stochastic);
    if (options.iterations <= 0 || rewriter.isIdentity())
        return grammar.axiom;

    std::size_t largest = grammar.axiom.size();
    if (!rewriter.hasChoices()) {
        const auto predicted = predictLargest(rewriter, grammar.axiom, options);
        RAMURE_TRY(predicted);
        largest = *predicted;
    }
    Buffer current, next;
    current.reserve(largest);
    next.reserve(largest);
    std::copy(grammar.axiom.begin(), grammar.axiom.end(), current.data.get());
    current.size = grammar.axiom.size();
    for (int iteration = 1; iteration <= options.iterations; ++iteration) {
        RAMURE_TRY(rewriteOnce(rewriter, current, next, iteration, options, progress));
        std::swap(current, next);
        progress.report(static_cast<double>(iteration) / options.iterations);
    }
    return std::string(current.view());
}

} // namespace ramure

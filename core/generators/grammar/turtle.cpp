#include "core/generators/grammar/turtle.h"

#include "core/base/wide_clone.h"
#include "core/generators/grammar/branch_keys.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/params/param_def.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

enum class Action : std::uint8_t { Grow, TurnX, TurnXBack, TurnY, TurnYBack, TurnZ, TurnZBack, Push, Pop };

constexpr std::array<Action, 256> makeActions()
{
    std::array<Action, 256> actions{};
    actions['+'] = Action::TurnX;
    actions['-'] = Action::TurnXBack;
    actions['/'] = Action::TurnY;
    actions['\\'] = Action::TurnYBack;
    actions['^'] = Action::TurnZ;
    actions['_'] = Action::TurnZBack;
    actions['['] = Action::Push;
    actions[']'] = Action::Pop;
    return actions;
}
constexpr std::array<Action, 256> actions = makeActions();

Action actionOf(char symbol)
{
    return actions[static_cast<unsigned char>(symbol)];
}

/// Of up to 255 symbols: a byte counts them, and vector instructions count in many bytes at once.
RAMURE_WIDE_CLONE std::size_t countFewCommands(const char* symbols, std::size_t count)
{
    std::uint8_t commands = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const char c = symbols[i];
        // A sum: the compiler makes one test with jumps of an or.
        commands = static_cast<std::uint8_t>(commands + (c == '+') + (c == '-') + (c == '/') + (c == '\\') +
                                             (c == '^') + (c == '_') + (c == '[') + (c == ']'));
    }
    return commands;
}

std::size_t countBranches(std::string_view symbols)
{
    constexpr std::size_t few = 224;
    std::size_t commands = 0;
    for (std::size_t from = 0; from < symbols.size(); from += few)
        commands += countFewCommands(symbols.data() + from, std::min(few, symbols.size() - from));
    return symbols.size() - commands;
}

/// A vector and a number that stays zero: always read and written in the same pieces. With three numbers a
/// state is copied in pieces that two writes made, and each waits until both have arrived.
struct Column
{
    using Two [[gnu::vector_size(16)]] = double;
    Two xy, z;
};

/// The turtle's matrix as its columns; its position is the end of the branch it stands on.
struct State
{
    Column x{{1.0, 0.0}, {0.0, 0.0}}, y{{0.0, 1.0}, {0.0, 0.0}}, z{{0.0, 0.0}, {1.0, 0.0}};
    double radius = 0.0;
    Index branch = noIndex;
    Index turns = 0; ///< by chance: since that branch
};

struct Level
{
    State state;
    std::size_t at = 0; ///< of the bracket that opened it
};

struct Turn
{
    double sine, cosine;
    [[nodiscard]] Turn back() const { return {-sine, cosine}; }
};

Turn turnBy(double angle)
{
    const auto [sine, cosine] = maths::sincos(angle);
    return {sine, cosine};
}

template <bool byChance> class Turtle
{
public:
    Turtle(const TurtleParams& params, const TurtleChance& chance, std::size_t branches)
        : m_alpha(params.alpha)
        , m_decay(params.decay)
        , m_theta(params.theta)
        , m_turn(turnBy(params.theta))
        , m_chance(chance)
    {
        m_levels.back().state.radius = params.alpha;
        m_skeleton.reserve(branches);
        m_children.reserve(branches);
    }

    /// \param offset of \p part in the whole string
    Expected<void> read(std::string_view part, std::size_t offset)
    {
        // Memory is first touched part by part: a large skeleton can be cancelled.
        const std::size_t branches = m_count + countBranches(part);
        m_skeleton.resize(branches);
        m_children.resize(branches, 0);
        Level* top = &m_levels.back();
        for (std::size_t i = 0; i < part.size(); ++i) {
            switch (actionOf(part[i])) {
            case Action::Grow:
                grow(top->state);
                break;
            case Action::TurnX:
                turn(top->state.y, top->state.z, nextTurn(top->state));
                break;
            case Action::TurnXBack:
                turn(top->state.y, top->state.z, nextTurn(top->state).back());
                break;
            case Action::TurnY:
                turn(top->state.z, top->state.x, nextTurn(top->state));
                break;
            case Action::TurnYBack:
                turn(top->state.z, top->state.x, nextTurn(top->state).back());
                break;
            case Action::TurnZ:
                turn(top->state.x, top->state.y, nextTurn(top->state));
                break;
            case Action::TurnZBack:
                turn(top->state.x, top->state.y, nextTurn(top->state).back());
                break;
            case Action::Push:
                if (m_levels.size() > maxBracketDepth)
                    return fail(ErrorCode::Limit, RAMURE_NOOP("brackets are nested deeper than %1"),
                                {std::to_string(maxBracketDepth)});
                m_levels.push_back({top->state, offset + i});
                top = &m_levels.back();
                break;
            case Action::Pop:
                if (m_levels.size() == 1)
                    return unbalanced(offset + i,
                                      RAMURE_NOOP("\"]\" without \"[\" before it, symbol %1 of the "
                                                  "rewritten string"));
                m_levels.pop_back();
                --top;
                break;
            }
        }
        return {};
    }

    Expected<Skeleton> finish()
    {
        if (m_levels.size() > 1)
            return unbalanced(m_levels.back().at,
                              RAMURE_NOOP("\"[\" is never closed, symbol %1 of the rewritten string"));
        return std::move(m_skeleton);
    }

private:
    static tl::unexpected<Error> unbalanced(std::size_t at, const char* text)
    {
        auto error = fail(ErrorCode::Invalid, text, {std::to_string(at + 1)});
        error.value().column = static_cast<int>(at) + 1;
        return error;
    }

    /// Post-multiplies by the rotation in the plane of two columns, from \p a towards \p b.
    static void turn(Column& a, Column& b, const Turn& by)
    {
        const Column before = a;
        a.xy = by.cosine * a.xy + by.sine * b.xy;
        a.z = by.cosine * a.z + by.sine * b.z;
        b.xy = by.cosine * b.xy - by.sine * before.xy;
        b.z = by.cosine * b.z - by.sine * before.z;
    }

    Turn nextTurn(State& state)
    {
        if constexpr (byChance) {
            if (m_chance.variation.angle != 0.0) {
                // Of the branch that would grow here: two brackets before it never draw the same.
                Random random(m_chance.seed, RandomStream::BranchTurn, nextKey(state) + state.turns++);
                return turnBy(varied(m_theta, m_chance.variation.angle, random));
            }
        }
        return m_turn;
    }

    static double varied(double value, double share, Random& random)
    {
        return value * (1.0 + share * random.range(-1.0, 1.0));
    }

    [[nodiscard]] std::uint64_t nextKey(const State& state) const
    {
        const bool isRoot = state.branch == noIndex;
        return branchKeyBelow(isRoot ? rootBranchKey : m_skeleton.key[state.branch],
                              isRoot ? m_roots : m_children[state.branch]);
    }

    void grow(State& state)
    {
        const Index parent = state.branch;
        const bool isRoot = parent == noIndex;
        const glm::dvec3 from = isRoot ? glm::dvec3(0.0) : m_skeleton.p1[parent];
        const std::uint64_t parentKey = isRoot ? rootBranchKey : m_skeleton.key[parent];
        const Index number = isRoot ? m_roots++ : m_children[parent]++;
        const Index i = m_count++;
        m_skeleton.parent[i] = parent;
        m_skeleton.p0[i] = from;
        const std::uint64_t key = branchKeyBelow(parentKey, number);
        double length = m_alpha, decay = m_decay;
        if constexpr (byChance) {
            Random random(m_chance.seed, RandomStream::BranchShape, key);
            length = varied(m_alpha, m_chance.variation.length, random);
            decay = std::min(varied(m_decay, m_chance.variation.radius, random), std::max(m_decay, 1.0));
            state.turns = 0;
        }
        m_skeleton.p1[i] = from + length * glm::dvec3(state.y.xy[0], state.y.xy[1], state.y.z[0]);
        m_skeleton.a0[i] = state.radius;
        state.radius *= decay;
        m_skeleton.a1[i] = state.radius;
        m_skeleton.level[i] = static_cast<Index>(m_levels.size() - 1);
        m_skeleton.key[i] = key;
        m_skeleton.source[i] = i;
        state.branch = i;
    }

    double m_alpha, m_decay, m_theta;
    Turn m_turn;
    TurtleChance m_chance;
    std::vector<Level> m_levels{Level()}; ///< the last one is where the turtle is
    std::vector<Index> m_children;        ///< children that each branch has so far
    Index m_roots = 0;
    Index m_count = 0;
    Skeleton m_skeleton;
};

Expected<void> checkTurtle(const TurtleParams& params)
{
    for (const double value : {params.theta, params.alpha, params.decay})
        if (!std::isfinite(value))
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("the turtle's angle, step and taper must be finite numbers"));
    if (params.alpha < 0.0 || params.decay < 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the turtle's step and taper cannot be negative"));
    return {};
}

template <bool byChance>
Expected<Skeleton> draw(std::string_view symbols, const TurtleParams& params, const TurtleChance& chance,
                        const Progress& progress)
{
    RAMURE_TRY(checkTurtle(params));
    const std::size_t branches = countBranches(symbols);
    if (branches > maxBranches)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the string draws %1 branches, more than the limit of %2"),
                    {std::to_string(branches), std::to_string(maxBranches)});
    Turtle<byChance> turtle(params, chance, branches);
    constexpr std::size_t stride = std::size_t(1) << 20;
    for (std::size_t from = 0; from < symbols.size(); from += stride) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        RAMURE_TRY(turtle.read(symbols.substr(from, stride), from));
        progress.report(static_cast<double>(from) / static_cast<double>(symbols.size()));
    }
    auto skeleton = turtle.finish();
    if (skeleton && skeleton->empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the grammar draws no branch at all"));
    return skeleton;
}

} // namespace

Expected<Skeleton> runTurtle(std::string_view symbols, const TurtleParams& params, const Progress& progress)
{
    return draw<false>(symbols, params, {}, progress);
}

Expected<Skeleton> runTurtle(std::string_view symbols, const TurtleParams& params, const TurtleChance& chance,
                             const Progress& progress)
{
    RAMURE_TRY(checkPart(&NodeParams::variation, chance.variation));
    return chance.variation == VariationParams{0.0, 0.0, 0.0} ? draw<false>(symbols, params, {}, progress)
                                                              : draw<true>(symbols, params, chance, progress);
}

} // namespace ramure

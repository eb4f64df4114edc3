#include "core/grammar/turtle.h"

#include "core/random/random.h"
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

std::size_t countBranches(std::string_view symbols)
{
    std::size_t commands = 0;
    for (const char c : symbols)
        commands +=
            c == '+' || c == '-' || c == '/' || c == '\\' || c == '^' || c == '_' || c == '[' || c == ']';
    return symbols.size() - commands;
}

/// The turtle's matrix as its columns; its position is the end of the branch it stands on.
struct State
{
    glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
    double radius = 0.0;
    Index branch = noIndex;
};

struct Saved
{
    State state;
    std::size_t at; ///< of the bracket
};

class Turtle
{
public:
    Turtle(const TurtleParams& params, std::size_t branches)
        : m_alpha(params.alpha)
        , m_decay(params.decay)
        , m_sin(std::sin(params.theta))
        , m_cos(std::cos(params.theta))
    {
        m_state.radius = params.alpha;
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
        for (std::size_t i = 0; i < part.size(); ++i) {
            switch (actionOf(part[i])) {
            case Action::Grow:
                grow();
                break;
            case Action::TurnX:
                turn(m_state.y, m_state.z, m_sin);
                break;
            case Action::TurnXBack:
                turn(m_state.y, m_state.z, -m_sin);
                break;
            case Action::TurnY:
                turn(m_state.z, m_state.x, m_sin);
                break;
            case Action::TurnYBack:
                turn(m_state.z, m_state.x, -m_sin);
                break;
            case Action::TurnZ:
                turn(m_state.x, m_state.y, m_sin);
                break;
            case Action::TurnZBack:
                turn(m_state.x, m_state.y, -m_sin);
                break;
            case Action::Push:
                if (m_stack.size() == maxBracketDepth)
                    return fail(ErrorCode::Limit, RAMURE_NOOP("brackets are nested deeper than %1"),
                                {std::to_string(maxBracketDepth)});
                m_stack.push_back({m_state, offset + i});
                break;
            case Action::Pop:
                if (m_stack.empty())
                    return unbalanced(offset + i,
                                      RAMURE_NOOP("\"]\" without \"[\" before it, symbol %1 of the "
                                                  "rewritten string"));
                m_state = m_stack.back().state;
                m_stack.pop_back();
                break;
            }
        }
        return {};
    }

    Expected<Skeleton> finish()
    {
        if (!m_stack.empty())
            return unbalanced(m_stack.back().at,
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
    void turn(glm::dvec3& a, glm::dvec3& b, double sine) const
    {
        const glm::dvec3 turned = m_cos * a + sine * b;
        b = m_cos * b - sine * a;
        a = turned;
    }

    void grow()
    {
        const Index parent = m_state.branch;
        const bool isRoot = parent == noIndex;
        const glm::dvec3 from = isRoot ? glm::dvec3(0.0) : m_skeleton.p1[parent];
        const std::uint64_t parentKey = isRoot ? rootKey : m_skeleton.key[parent];
        const Index number = isRoot ? m_roots++ : m_children[parent]++;
        const Index i = m_count++;
        m_skeleton.parent[i] = parent;
        m_skeleton.p0[i] = from;
        m_skeleton.p1[i] = from + m_alpha * m_state.y;
        m_skeleton.a0[i] = m_state.radius;
        m_state.radius *= m_decay;
        m_skeleton.a1[i] = m_state.radius;
        m_skeleton.level[i] = static_cast<Index>(m_stack.size());
        m_skeleton.key[i] = mixBits(parentKey + keyStep * (std::uint64_t(number) + 1));
        m_skeleton.source[i] = i;
        m_state.branch = i;
    }

    /// Both are part of the file format: per-branch values are saved by key.
    static constexpr std::uint64_t rootKey = 0x52616D757265ull;
    static constexpr std::uint64_t keyStep = 0x9E3779B97F4A7C15ull;

    double m_alpha, m_decay, m_sin, m_cos;
    State m_state;
    std::vector<Saved> m_stack;
    std::vector<Index> m_children; ///< children that each branch has so far
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

} // namespace

Expected<Skeleton> runTurtle(std::string_view symbols, const TurtleParams& params, const Progress& progress)
{
    if (auto ok = checkTurtle(params); !ok)
        return fail(ok.error());
    const std::size_t branches = countBranches(symbols);
    if (branches > maxBranches)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the string draws %1 branches, more than the limit of %2"),
                    {std::to_string(branches), std::to_string(maxBranches)});
    Turtle turtle(params, branches);
    constexpr std::size_t stride = std::size_t(1) << 20;
    for (std::size_t from = 0; from < symbols.size(); from += stride) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        if (auto done = turtle.read(symbols.substr(from, stride), from); !done)
            return fail(done.error());
        progress.report(static_cast<double>(from) / static_cast<double>(symbols.size()));
    }
    auto skeleton = turtle.finish();
    if (skeleton && skeleton->empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the grammar draws no branch at all"));
    return skeleton;
}

} // namespace ramure

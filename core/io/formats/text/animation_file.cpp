#include "core/io/formats/text/animation_file.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/io/read_parts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace ramure {
namespace {

constexpr std::size_t plainColumns = 12, shapeColumns = 16, allColumns = 56;
constexpr std::string_view ownHeader = "# ramure-animation";

/// Where a channel of Blender (loc x y z, rot x y z w, scale x y z) goes: Z up becomes Y up by p = (x, z,
/// -y), q = (w, x, z, -y), s = (sx, sz, sy).
struct Axis
{
    std::size_t column; ///< 0 .. 9
    double sign;
};
constexpr std::array<Axis, 3> translationAxes{Axis{0, 1.0}, Axis{2, 1.0}, Axis{1, -1.0}};
constexpr std::array<Axis, 4> orientationAxes{Axis{6, 1.0}, Axis{3, 1.0}, Axis{5, 1.0}, Axis{4, -1.0}};
constexpr std::array<Axis, 3> scaleAxes{Axis{7, 1.0}, Axis{9, 1.0}, Axis{8, 1.0}};

/// One line.
struct KeyRow
{
    KeyShape shape;
    std::array<double, 10> values{};
    std::array<Handle, 10> in{}, out{};
    bool hasHandles = false;
    int line = 0;
};

class Parser
{
public:
    Parser(const std::string& file, CubicMeaning cubic)
        : m_file(file)
        , m_cubic(cubic)
    {
    }

    Expected<AnimationFile> parse(std::string_view text)
    {
        const PlainText plain(text);
        for (TextLines lines(plain.view()); lines.next();) {
            m_line = lines.number();
            RAMURE_TRY(readLine(lines.line()));
        }
        RAMURE_TRY(makeTracks());
        return std::move(m_out);
    }

private:
    tl::unexpected<Error> bad(ErrorCode code, const char* text, std::vector<std::string> args = {}) const
    {
        auto error = fail(code, text, std::move(args));
        error.value().file = m_file;
        error.value().line = m_line;
        return error;
    }
    void note(const char* text, std::vector<std::string> args = {}, int line = 0)
    {
        Note note = fail(ErrorCode::Invalid, text, std::move(args)).value();
        note.file = m_file;
        note.line = line;
        m_out.notes.push_back(std::move(note));
    }

    Expected<void> readLine(std::string_view line)
    {
        if (line.empty())
            return {};
        if (line.front() != '#')
            return readKey(line);
        if (line.starts_with(ownHeader))
            m_out.ownScript = true;
        const std::string_view rest = reading::trimmed(line.substr(1));
        if (rest.starts_with("parent="))
            m_out.parent = std::string(reading::trimmed(rest.substr(7)));
        if (rest.starts_with("fps="))
            return setNumber(rest.substr(4), m_out.framesPerSecond);
        if (rest.starts_with("loop="))
            return setNumber(rest.substr(5), m_loopSeconds);
        return {};
    }
    Expected<void> setNumber(std::string_view text, double& into)
    {
        const auto read = number(text);
        RAMURE_TRY(read);
        if (*read < 0.0 || *read > 1e6)
            return bad(ErrorCode::Invalid, RAMURE_NOOP("must be between %1 and %2, not %3"),
                       {"0", "1000000", numberText(*read)});
        into = *read;
        return {};
    }
    Expected<double> number(std::string_view text) const
    {
        std::string_view digits = reading::trimmed(text);
        if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
            digits.remove_prefix(1);
        double value = 0.0;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (status != std::errc() || end != digits.data() + digits.size())
            return bad(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is not a number"),
                       {std::string(reading::trimmed(text))});
        if (!std::isfinite(value))
            return bad(ErrorCode::Invalid, RAMURE_NOOP("must be a finite number"));
        return value;
    }

    Expected<void> readKey(std::string_view line)
    {
        std::vector<std::string_view> cells;
        for (std::size_t from = 0; from <= line.size();) {
            const std::size_t comma = std::min(line.find(',', from), line.size());
            cells.push_back(reading::trimmed(line.substr(from, comma - from)));
            from = comma + 1;
        }
        const std::size_t count = cells.size();
        if (count != plainColumns && !(m_out.ownScript && (count == shapeColumns || count == allColumns)))
            return bad(
                ErrorCode::Syntax,
                RAMURE_NOOP("%1 columns, %2 are expected: time,MODE and ten numbers with decimal points"),
                {std::to_string(count), std::to_string(plainColumns)});
        KeyRow row;
        row.line = m_line;
        const auto time = number(cells[0]);
        RAMURE_TRY(time);
        if (std::abs(*time) > 1e6)
            return bad(ErrorCode::Invalid, RAMURE_NOOP("the time lies beyond a million seconds"));
        row.shape.time = ticksOf(*time);
        for (std::size_t i = 0; i < row.values.size(); ++i) {
            const auto value = number(cells[i + 2]);
            RAMURE_TRY(value);
            row.values[i] = *value;
        }
        readMode(row.shape, cells[1]);
        if (count > plainColumns)
            if (auto read = readMore(row, cells); !read)
                return read;
        if (auto good = checkRotation(row); !good)
            return good;
        m_rows.push_back(row);
        return {};
    }
    void readMode(KeyShape& shape, std::string_view name)
    {
        for (int i = 0; i < keyModeCount; ++i)
            if (isWord(name, lowered(keyModeName(static_cast<KeyMode>(i)))))
                shape.mode = static_cast<KeyMode>(i);
        const bool known = isWord(name, lowered(keyModeName(shape.mode)));
        if (known && shape.mode != KeyMode::CubicEase)
            return;
        const bool easing =
            m_cubic == CubicMeaning::Easing || (m_cubic == CubicMeaning::Automatic && m_out.ownScript);
        if (known && easing)
            return;
        shape.mode = KeyMode::Cubic;
        if (known ? !std::exchange(m_saidSpline, true) : m_unknown.insert(std::string(name)).second)
            known ? note(RAMURE_NOOP("CUBIC is read as the spline through the keys, not as Blender's easing"),
                         {}, m_line)
                  : note(RAMURE_NOOP("the mode \"%1\" is not known: read as a CUBIC spline"),
                         {std::string(name)}, m_line);
    }
    Expected<void> readMore(KeyRow& row, const std::vector<std::string_view>& cells)
    {
        bool known = false;
        for (int i = 0; i < easingCount; ++i)
            if (isWord(cells[plainColumns], lowered(easingName(static_cast<Easing>(i))))) {
                row.shape.easing = static_cast<Easing>(i);
                known = true;
            }
        if (!known)
            note(RAMURE_NOOP("the easing \"%1\" is not known: read as AUTO"),
                 {std::string(cells[plainColumns])}, m_line);
        std::vector<double> numbers;
        for (std::size_t i = plainColumns + 1; i < cells.size(); ++i) {
            const auto value = number(cells[i]);
            RAMURE_TRY(value);
            numbers.push_back(*value);
        }
        row.shape.back = numbers[0];
        row.shape.amplitude = std::max(numbers[1], 0.0);
        row.shape.period = std::max(numbers[2], 0.0);
        row.hasHandles = cells.size() == allColumns;
        for (std::size_t i = 0; row.hasHandles && i < row.in.size(); ++i) {
            row.in[i] = {numbers[3 + 4 * i], numbers[4 + 4 * i]};
            row.out[i] = {numbers[5 + 4 * i], numbers[6 + 4 * i]};
        }
        return {};
    }
    Expected<void> checkRotation(const KeyRow& row)
    {
        double square = 0.0;
        for (std::size_t i = 3; i < 7; ++i)
            square += row.values[i] * row.values[i];
        if (square < 1e-12)
            return bad(ErrorCode::Invalid, RAMURE_NOOP("a quaternion of this length has no direction"));
        if (std::abs(std::sqrt(square) - 1.0) > 1e-3 && !std::exchange(m_saidUnit, true))
            note(RAMURE_NOOP("a quaternion is no unit: only its direction counts"), {}, m_line);
        return {};
    }

    /// Sorted, of several at one time the last.
    void sortRows()
    {
        for (std::size_t i = 1; i < m_rows.size(); ++i)
            if (m_rows[i].shape.time <= m_rows[i - 1].shape.time) {
                const bool same = m_rows[i].shape.time == m_rows[i - 1].shape.time;
                note(same ? RAMURE_NOOP("two keys at one time: the last counts")
                          : RAMURE_NOOP("the keys are not in order: sorted by time"),
                     {}, m_rows[i].line);
                break;
            }
        std::stable_sort(m_rows.begin(), m_rows.end(),
                         [](const KeyRow& a, const KeyRow& b) { return a.shape.time < b.shape.time; });
        const auto kept = std::unique(m_rows.rbegin(), m_rows.rend(), [](const KeyRow& a, const KeyRow& b) {
            return a.shape.time == b.shape.time;
        });
        m_rows.erase(m_rows.begin(), kept.base());
    }
    static Handle turned(const Handle& handle, double sign) { return {handle.dt, sign * handle.dv}; }
    static KeyShape shapeOf(const KeyRow& row)
    {
        KeyShape shape = row.shape;
        if (row.hasHandles)
            shape.before = shape.behind = HandleType::Free;
        return shape;
    }
    template <class TrackType> void keep(const Channel& channel, TrackType track)
    {
        track.loop = ticksOf(m_loopSeconds);
        track.settleEnds();
        m_out.animation.set(channel, AnyTrack(std::move(track)));
    }
    Expected<void> addNumbers(ChannelPart part, const std::array<Axis, 3>& axes)
    {
        for (std::uint8_t c = 0; c < 3; ++c) {
            const Axis& axis = axes[c];
            std::vector<Key> keys(m_rows.size());
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const KeyRow& row = m_rows[i];
                static_cast<KeyShape&>(keys[i]) = shapeOf(row);
                keys[i].value = axis.sign * row.values[axis.column];
                keys[i].in = turned(row.in[axis.column], axis.sign);
                keys[i].out = turned(row.out[axis.column], axis.sign);
            }
            auto track = Track::fromKeys(std::move(keys));
            RAMURE_TRY(track);
            keep({part, c, 0}, std::move(*track));
        }
        return {};
    }
    Expected<void> addOrientation()
    {
        std::vector<OrientationKey> keys(m_rows.size());
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const KeyRow& row = m_rows[i];
            static_cast<KeyShape&>(keys[i]) = shapeOf(row);
            double q[4];
            for (std::size_t c = 0; c < 4; ++c) {
                const Axis& axis = orientationAxes[c];
                q[c] = axis.sign * row.values[axis.column];
                keys[i].in[c] = turned(row.in[axis.column], axis.sign);
                keys[i].out[c] = turned(row.out[axis.column], axis.sign);
            }
            keys[i].value = {q[0], q[1], q[2], q[3]};
        }
        auto track = OrientationTrack::fromKeys(std::move(keys));
        RAMURE_TRY(track);
        track->blend = m_out.ownScript ? OrientationBlend::Components : OrientationBlend::Classic;
        keep({ChannelPart::GlobalOrientation, 0, 0}, std::move(*track));
        return {};
    }
    Expected<void> makeTracks()
    {
        m_out.keyCount = m_rows.size();
        if (m_rows.empty()) {
            note(RAMURE_NOOP("the file has no keys: the object does not move"));
            return {};
        }
        sortRows();
        m_out.keyCount = m_rows.size();
        const bool bezier = std::any_of(m_rows.begin(), m_rows.end(), [](const KeyRow& row) {
            return row.shape.mode == KeyMode::Bezier && !row.hasHandles;
        });
        if (bezier)
            note(RAMURE_NOOP("BEZIER without handles: they are set as Blender sets them for new keys"));
        if (m_loopSeconds > 0.0 && m_rows.front().values != m_rows.back().values)
            note(RAMURE_NOOP("the loop jumps: its last key is not the first one"));
        auto done = addNumbers(ChannelPart::GlobalTranslation, translationAxes);
        if (done)
            done = addOrientation();
        return done ? addNumbers(ChannelPart::GlobalScale, scaleAxes) : done;
    }

    std::string m_file;
    CubicMeaning m_cubic;
    AnimationFile m_out;
    std::vector<KeyRow> m_rows;
    std::set<std::string> m_unknown;
    double m_loopSeconds = 0.0;
    int m_line = 0;
    bool m_saidSpline = false, m_saidUnit = false;
};

} // namespace

Expected<AnimationFile> parseAnimation(std::string_view text, const std::string& file, CubicMeaning cubic)
{
    return Parser(file, cubic).parse(text);
}

namespace {

/// The ten channels, those without a track at rest.
struct Channels
{
    std::array<const Track*, 3> translation{}, scale{};
    const OrientationTrack* orientation = nullptr;
    std::vector<const AnyTrack*> all;

    explicit Channels(const NodeAnimation& animation)
    {
        for (const auto& [channel, track] : animation.tracks()) {
            if (channel.part == ChannelPart::GlobalTranslation)
                translation[channel.component] = std::get_if<Track>(track.get());
            else if (channel.part == ChannelPart::GlobalScale)
                scale[channel.component] = std::get_if<Track>(track.get());
            else if (channel.part == ChannelPart::GlobalOrientation)
                orientation = std::get_if<OrientationTrack>(track.get());
            else
                continue;
            all.push_back(track.get());
        }
    }
    /// All keys at the same times, of one shape, and nothing that a line of the file cannot say.
    [[nodiscard]] bool agree() const
    {
        const auto plain = [](const AnyTrack& track) {
            return std::visit(
                [](const auto& t) {
                    return t.before == Extrapolation::Hold && t.behind == Extrapolation::Hold;
                },
                track);
        };
        for (const AnyTrack* track : all) {
            if (!plain(*track) || keyCount(*track) != keyCount(*all.front()))
                return false;
            for (std::size_t i = 0; i < keyCount(*track); ++i) {
                const KeyShape &a = keyShape(*track, i), &b = keyShape(*all.front(), i);
                if (a.time != b.time || a.mode != b.mode || a.easing != b.easing || a.back != b.back ||
                    a.amplitude != b.amplitude || a.period != b.period || a.mode == KeyMode::Cubic)
                    return false;
            }
        }
        const bool turns = orientation && orientation->blend != OrientationBlend::Components;
        return !(turns && std::any_of(orientation->keys().begin(), orientation->keys().end(),
                                      [](const OrientationKey& key) {
                                          return key.mode != KeyMode::Bezier && key.mode != KeyMode::Constant;
                                      }));
    }
};

/// Values and handles of one time, in Blender's order.
struct Line
{
    std::array<double, 10> values{0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
    std::array<Handle, 10> in{}, out{};

    void set(const Axis& axis, double value, const Handle& before = {}, const Handle& behind = {})
    {
        values[axis.column] = axis.sign * value;
        in[axis.column] = {before.dt, axis.sign * before.dv};
        out[axis.column] = {behind.dt, axis.sign * behind.dv};
    }
};

double partOf(const glm::dquat& q, std::size_t c)
{
    return c == 0 ? q.w : c == 1 ? q.x : c == 2 ? q.y : q.z;
}

Line keyLine(const Channels& channels, std::size_t i)
{
    Line line;
    for (std::size_t c = 0; c < 3; ++c) {
        if (const Track* track = channels.translation[c]) {
            const Key& key = track->keys()[i];
            line.set(translationAxes[c], key.value, key.in, key.out);
        }
        if (const Track* track = channels.scale[c]) {
            const Key& key = track->keys()[i];
            line.set(scaleAxes[c], key.value, key.in, key.out);
        }
    }
    for (std::size_t c = 0; channels.orientation && c < 4; ++c) {
        const OrientationKey& key = channels.orientation->keys()[i];
        line.set(orientationAxes[c], partOf(key.value, c), key.in[c], key.out[c]);
    }
    return line;
}

Line sampledLine(const Channels& channels, double seconds)
{
    Line line;
    for (std::size_t c = 0; c < 3; ++c) {
        if (const Track* track = channels.translation[c])
            line.set(translationAxes[c], valueAt(*track, seconds));
        if (const Track* track = channels.scale[c])
            line.set(scaleAxes[c], valueAt(*track, seconds));
    }
    if (channels.orientation) {
        const glm::dquat q = valueAt(*channels.orientation, seconds);
        for (std::size_t c = 0; c < 4; ++c)
            line.set(orientationAxes[c], partOf(q, c));
    }
    return line;
}

void append(std::string& text, const KeyShape& shape, const Line& line, bool handles)
{
    text.append(numberText(secondsOf(shape.time))).append(",").append(keyModeName(shape.mode));
    for (const double value : line.values)
        text.append(",").append(numberText(value + 0.0));
    text.append(",").append(easingName(shape.easing));
    for (const double value : {shape.back, shape.amplitude, shape.period})
        text.append(",").append(numberText(value));
    for (std::size_t c = 0; handles && c < line.in.size(); ++c)
        for (const double value : {line.in[c].dt, line.in[c].dv, line.out[c].dt, line.out[c].dv})
            text.append(",").append(numberText(value + 0.0));
    text.append("\n");
}

/// Every frame from the first key to the last, and every key.
void appendSamples(std::string& text, const NodeAnimation& animation, const Channels& channels,
                   double framesPerSecond)
{
    std::set<Ticks> times;
    for (const AnyTrack* track : channels.all)
        for (std::size_t i = 0; i < keyCount(*track); ++i)
            times.insert(keyShape(*track, i).time);
    const auto [first, last] = rangeOf(animation);
    for (double frame = std::ceil(secondsOf(first) * framesPerSecond);
         frame / framesPerSecond <= secondsOf(last); frame += 1.0)
        times.insert(ticksOf(frame / framesPerSecond));
    KeyShape shape;
    shape.mode = KeyMode::Linear;
    for (const Ticks time : times) {
        shape.time = time;
        append(text, shape, sampledLine(channels, secondsOf(time)), false);
    }
}

} // namespace

std::string animationText(const NodeAnimation& animation, double framesPerSecond, const std::string& parent,
                          bool* baked)
{
    std::string text(ownHeader);
    text.append(" 1\n# fps=").append(numberText(framesPerSecond)).append("\n");
    if (!parent.empty())
        text.append("# parent=").append(parent).append("\n");
    const Channels channels(animation);
    const bool agree = channels.agree();
    if (baked)
        *baked = !agree;
    if (channels.all.empty())
        return text;
    const Ticks loop = std::visit([](const auto& track) { return track.loop; }, *channels.all.front());
    if (loop > 0)
        text.append("# loop=").append(numberText(secondsOf(loop))).append("\n");
    if (!agree)
        appendSamples(text, animation, channels, framesPerSecond);
    for (std::size_t i = 0; agree && i < keyCount(*channels.all.front()); ++i)
        append(text, keyShape(*channels.all.front(), i), keyLine(channels, i), true);
    return text;
}

} // namespace ramure

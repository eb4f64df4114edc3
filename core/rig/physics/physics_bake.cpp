#include "core/rig/physics/physics_bake.h"

#include "core/base/file_writer.h"
#include "core/math/random.h"
#include "core/params/param_def.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace ramure {
namespace {

static_assert(std::endian::native == std::endian::little, "words go to the file as they lie in memory");

using Word = std::uint64_t;
constexpr std::array<char, sizeof(Word)> magicWord{'R', 'A', 'M', 'R', 'P', 'H', 'Y', 'S'};
constexpr Word version = 2;          ///< 1 knew no settled trees
constexpr std::size_t headWords = 3; // magic, version, number of words
constexpr std::size_t stateHeadWords = 7, appleWords = 15, limbWords = 15;

/// \param sum of what stands before; the file's version at the beginning.
Word checksumOf(const std::vector<Word>& words, Word sum)
{
    for (const Word word : words)
        sum = mixBits(sum * 0x9E3779B97F4A7C15ull + word + 1);
    return sum;
}

class WordWriter
{
public:
    explicit WordWriter(std::vector<Word>& out)
        : m_out(out)
    {
    }
    void add(double value) { m_out.push_back(std::bit_cast<Word>(value)); }
    void add(const glm::dvec3& v) { add(v.x), add(v.y), add(v.z); }
    template <class T> void add(T value) requires(std::is_integral_v<T> || std::is_enum_v<T>)
    {
        m_out.push_back(static_cast<Word>(value));
    }

    void add(const PhysicsScript& script)
    {
        add(script.paramChanges().size());
        for (const auto& [from, params] : script.paramChanges()) {
            add(from);
            visitFields(params, [this](const auto& field) { add(field); });
        }
        add(script.pullChanges().size());
        for (const auto& [from, pull] : script.pullChanges()) {
            add(from), add(pull.has_value());
            if (pull)
                add(pull->branch), add(pull->along), add(pull->target), add(pull->strength);
        }
        add(script.appleChanges().size());
        for (const auto& [at, apple] : script.appleChanges())
            add(at), add(apple);
    }
    void add(const PhysicsState& state)
    {
        add(state.step), add(state.timeSeconds), add(state.clockTime), add(state.clockStepSeconds);
        add(state.clockStep), add(state.mode), add(state.loose.size());
        for (const LooseApple& apple : state.loose) {
            add(apple.apple), add(apple.resting), add(apple.position);
            add(apple.orientation.w), add(apple.orientation.x), add(apple.orientation.y),
                add(apple.orientation.z);
            add(apple.velocity), add(apple.spin);
        }
        for (const FallingLimb& limb : state.limbs) { // as many as the body has
            add(limb.phase), add(limb.calm), add(limb.centre);
            add(limb.rotation.w), add(limb.rotation.x), add(limb.rotation.y), add(limb.rotation.z);
            add(limb.velocity), add(limb.spin);
        }
        for (const double value : state.values)
            add(value);
    }

private:
    std::vector<Word>& m_out;
};

/// Reads words one by one; after the first that cannot be, everything is zero and isGood() says so.
class WordReader
{
public:
    WordReader(const std::vector<Word>& words, Word fileVersion)
        : m_words(words)
        , m_version(fileVersion)
    {
    }
    [[nodiscard]] bool isGood() const { return m_good; }
    [[nodiscard]] bool isAtEnd() const { return m_next == m_words.size(); }
    void demand(bool holds) { m_good = m_good && holds; }

    Word word(Word most = ~Word(0))
    {
        demand(m_next < m_words.size());
        const Word value = m_good ? m_words[m_next++] : 0;
        demand(value <= most);
        return m_good ? value : 0;
    }
    double real()
    {
        const double value = std::bit_cast<double>(word());
        demand(std::isfinite(value));
        return m_good ? value : 0.0;
    }
    glm::dvec3 vector()
    {
        const double x = real(), y = real();
        return {x, y, real()};
    }
    glm::dquat unitRotation()
    {
        glm::dquat q;
        q.w = real(), q.x = real(), q.y = real(), q.z = real();
        demand(std::abs(glm::length(q) - 1.0) < 1e-9);
        return q;
    }
    std::int64_t step() { return static_cast<std::int64_t>(word(maxPhysicsSteps)); }
    /// A count of things of at least \p each words.
    std::size_t count(std::size_t each)
    {
        const auto value = static_cast<std::size_t>(word(m_words.size()));
        demand(value <= (m_words.size() - m_next) / each);
        return m_good ? value : 0;
    }
    template <class T> void field(T& out)
    {
        if constexpr (std::is_enum_v<T>)
            out = static_cast<T>(word(1));
        else if constexpr (std::is_same_v<T, bool>)
            out = word(1) == 1;
        else if constexpr (std::is_integral_v<T>)
            out = static_cast<T>(word());
        else
            out = real();
    }
    PhysicsParams physics()
    {
        PhysicsParams params;
        visitFields(params, [&](auto& each) {
            if (static_cast<const void*>(&each) != &params.settled || m_version > 1)
                field(each);
        });
        params.settled = params.settled && m_version > 1;
        return params;
    }

private:
    const std::vector<Word>& m_words;
    Word m_version;
    std::size_t m_next = 0;
    bool m_good = true;
};

struct Baked
{
    PhysicsScript script{PhysicsParams()};
    std::vector<PhysicsState> states;
    int checkpointSteps = 1;
};

void readParams(WordReader& in, PhysicsScript& out)
{
    const std::size_t count = in.count(2);
    in.demand(count > 0);
    std::int64_t last = -1;
    for (std::size_t i = 0; i < count && in.isGood(); ++i) {
        const std::int64_t from = in.step();
        in.demand(i == 0 ? from == 0 : from > last);
        last = from;
        NodeParams node;
        node.physics = in.physics();
        in.demand(in.isGood() && checkParams(node).has_value());
        if (in.isGood())
            out.setParams(node.physics, from);
    }
}

void readHand(WordReader& in, const TreeBody& body, PhysicsScript& out)
{
    std::int64_t last = -1;
    for (std::size_t count = in.count(2); count > 0 && in.isGood(); --count) {
        const std::int64_t from = in.step();
        in.demand(from > last);
        last = from;
        std::optional<Pull> pull;
        if (in.word(1) == 1) {
            pull.emplace();
            pull->branch = static_cast<Index>(in.word(noIndex));
            pull->along = in.real();
            pull->target = in.vector();
            pull->strength = in.real();
        }
        if (in.isGood())
            out.setPull(pull, from);
    }
    for (std::size_t count = in.count(2); count > 0 && in.isGood(); --count) {
        const std::int64_t at = in.step();
        const auto apple = static_cast<Index>(in.word(noIndex));
        in.demand(apple < body.appleSlot.size());
        if (in.isGood())
            out.shakeOff(apple, at);
    }
}

LooseApple readApple(WordReader& in, const TreeBody& body)
{
    LooseApple apple;
    apple.apple = static_cast<Index>(in.word(noIndex));
    in.demand(apple.apple < body.appleSlot.size());
    apple.resting = in.word(1) == 1;
    apple.position = in.vector();
    apple.orientation = in.unitRotation();
    apple.velocity = in.vector();
    apple.spin = in.vector();
    return apple;
}

FallingLimb readLimb(WordReader& in)
{
    FallingLimb limb;
    limb.phase = static_cast<LimbPhase>(in.word(static_cast<Word>(LimbPhase::Resting)));
    limb.calm = in.step();
    limb.centre = in.vector();
    limb.rotation = in.unitRotation();
    limb.velocity = in.vector();
    limb.spin = in.vector();
    return limb;
}

void demandUnitRotations(WordReader& in, const PhysicsState& state)
{
    for (Index slot = 0; slot < state.slotCount && in.isGood(); ++slot) {
        double sum = 0.0;
        for (int c = PhysicsState::RotW; c <= PhysicsState::RotZ; ++c)
            sum += state.channel(c)[slot] * state.channel(c)[slot];
        in.demand(std::abs(sum - 1.0) < 1e-9);
    }
}

PhysicsState readState(WordReader& in, const TreeBody& body, const HeldWeight& held)
{
    PhysicsState state;
    state.held = held;
    state.step = in.step();
    state.timeSeconds = in.real();
    state.clockTime = in.real();
    state.clockStepSeconds = in.real();
    state.clockStep = in.step();
    in.field(state.mode);
    state.slotCount = body.size();
    for (std::size_t count = in.count(appleWords); count > 0 && in.isGood(); --count)
        state.loose.push_back(readApple(in, body));
    for (std::size_t i = 0; i < body.limbs.size() && in.isGood(); ++i)
        state.limbs.push_back(readLimb(in));
    if (!in.isGood())
        return state;
    state.values.resize(std::size_t(state.channels()) * state.slotCount);
    for (double& value : state.values)
        value = in.real();
    demandUnitRotations(in, state);
    return state;
}

tl::unexpected<Error> refuse(const std::string& file, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().file = file;
    return error;
}

struct FileWords
{
    Word version = 0;
    std::vector<Word> words; ///< without head and checksum
};

bool isKnown(Word fileVersion)
{
    return fileVersion >= 1 && fileVersion <= version;
}

Expected<FileWords> readWords(const std::string& path)
{
    std::error_code status; // a folder opens, and then has no end
    const std::uintmax_t bytes = std::filesystem::file_size(path, status);
    std::ifstream file(path, std::ios::binary);
    if (status || !file)
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"),
                      {status ? status.message() : std::generic_category().message(errno)});
    std::vector<Word> words(static_cast<std::size_t>(bytes) / sizeof(Word));
    file.read(reinterpret_cast<char*>(words.data()),
              static_cast<std::streamsize>(words.size() * sizeof(Word)));
    if (!file)
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"),
                      {std::generic_category().message(errno)});
    if (words.empty() || words[0] != std::bit_cast<Word>(magicWord))
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("not a file of baked motion"));
    if (words.size() > 1 && !isKnown(words[1]))
        return refuse(path, ErrorCode::Version,
                      RAMURE_NOOP("baked motion of version %1; this program knows version %2"),
                      {std::to_string(words[1]), std::to_string(version)});
    const bool isWhole = words.size() > headWords && words[2] == words.size() - headWords - 1 &&
                         bytes == words.size() * sizeof(Word);
    if (!isWhole)
        return refuse(path, ErrorCode::Syntax,
                      RAMURE_NOOP("the file is cut short, or something follows its end"));
    const Word checksum = words.back(), fileVersion = words[1];
    words.pop_back();
    words.erase(words.begin(), words.begin() + headWords);
    if (checksumOf(words, fileVersion) != checksum)
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("the file is damaged: its checksum differs"));
    return FileWords{fileVersion, std::move(words)};
}

/// \param wanted null: any run.
Expected<Baked> readBake(const std::string& path, const TreeBody& body, const PhysicsParams* wanted,
                         const Progress& progress)
{
    const auto file = readWords(path);
    RAMURE_TRY(file);
    WordReader in(file->words, file->version);
    const bool isThisTree = in.word() == body.key && in.word() == body.size();
    if (!isThisTree)
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("this motion was baked from another tree"));
    Baked out;
    out.checkpointSteps = static_cast<int>(in.word(Word(maxPhysicsSteps) * 2));
    in.demand(out.checkpointSteps > 0);
    readParams(in, out.script);
    readHand(in, body, out.script);
    if (wanted && in.isGood() && !(out.script == PhysicsScript(*wanted)))
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("this motion was baked with other parameters"));
    const HeldWeight held = heldWeight(out.script.paramsAt(0));
    const std::size_t count = in.count(stateHeadWords);
    for (std::size_t i = 0; i < count && in.isGood(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        progress.report(static_cast<double>(i) / static_cast<double>(count));
        PhysicsState state = readState(in, body, held);
        in.demand(out.states.empty() ? state.step > 0 : state.step > out.states.back().step);
        out.states.push_back(std::move(state));
    }
    if (!in.isGood() || !in.isAtEnd())
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("the file holds values that cannot be"));
    return out;
}

std::size_t wordCount(const PhysicsState& state)
{
    return stateHeadWords + appleWords * state.loose.size() + limbWords * state.limbs.size() +
           state.values.size();
}

void append(FileWriter& file, const std::vector<Word>& words)
{
    file.append({reinterpret_cast<const char*>(words.data()), words.size() * sizeof(Word)});
}

} // namespace

Expected<void> saveBake(PhysicsCache& cache, std::int64_t lastStep, const std::string& path,
                        const Progress& progress)
{
    // Before the long work: a folder that is missing.
    auto file = FileWriter::open(path);
    RAMURE_TRY(file);
    if (auto done = cache.seek(lastStep, progress.part(0.0, 0.9)); !done)
        return done;
    std::vector<const PhysicsState*> states;
    for (const PhysicsState* state : cache.validStates())
        if (state->step > 0 && state->step <= lastStep &&
            (state->step % cache.checkpointSteps() == 0 || state->step == lastStep))
            states.push_back(state);
    std::vector<Word> head;
    WordWriter out(head);
    const TreeBody& body = cache.physics().body();
    out.add(body.key), out.add(body.size()), out.add(cache.checkpointSteps());
    out.add(cache.script());
    out.add(states.size());
    // State by state: all together may be as large as the cache.
    std::vector<Word> words;
    const auto wordsOf = [&](const PhysicsState& state) {
        words.clear();
        WordWriter(words).add(state);
    };
    std::size_t count = head.size();
    for (const PhysicsState* state : states)
        count += wordCount(*state);
    append(*file, {std::bit_cast<Word>(magicWord), version, count});
    append(*file, head);
    Word checksum = checksumOf(head, version);
    for (std::size_t i = 0; i < states.size() && file->isGood(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        progress.report(0.9 + 0.1 * static_cast<double>(i) / static_cast<double>(states.size()));
        wordsOf(*states[i]);
        append(*file, words);
        checksum = checksumOf(words, checksum);
    }
    append(*file, {checksum});
    progress.report(1.0);
    return file->commit();
}

static Expected<void> load(PhysicsCache& cache, const PhysicsParams* wanted, const std::string& path,
                           const Progress& progress)
{
    auto baked = readBake(path, cache.physics().body(), wanted, progress);
    RAMURE_TRY(baked);
    cache.setScript(baked->script);
    cache.takeStates(std::move(baked->states), baked->checkpointSteps);
    return {};
}

Expected<void> loadBake(PhysicsCache& cache, const std::string& path, const Progress& progress)
{
    return load(cache, nullptr, path, progress);
}

Expected<void> loadBake(PhysicsCache& cache, const PhysicsParams& params, const std::string& path,
                        const Progress& progress)
{
    return load(cache, &params, path, progress);
}

Expected<BakeLabel> readBakeLabel(const std::string& path)
{
    constexpr std::size_t most = 64; // more than all that stands before the second set of parameters
    std::array<Word, most> read{};
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return refuse(path, ErrorCode::Io, RAMURE_NOOP("cannot be read: %1"),
                      {std::generic_category().message(errno)});
    file.read(reinterpret_cast<char*>(read.data()), sizeof(read));
    std::vector<Word> words(read.begin(), read.begin() + file.gcount() / std::streamsize(sizeof(Word)));
    if (words.size() < headWords || words[0] != std::bit_cast<Word>(magicWord) || !isKnown(words[1]))
        return refuse(path, ErrorCode::Syntax, RAMURE_NOOP("not a file of baked motion"));
    const Word fileVersion = words[1];
    words.erase(words.begin(), words.begin() + headWords);
    WordReader in(words, fileVersion);
    BakeLabel label;
    label.bodyKey = in.word();
    in.word(), in.word(), in.word(), in.word(); // slots, checkpoints, number of changes, step of the first
    NodeParams node;
    node.physics = in.physics();
    if (!in.isGood() || !checkParams(node))
        return refuse(path, ErrorCode::Invalid, RAMURE_NOOP("the file holds values that cannot be"));
    label.params = node.physics;
    return label;
}

bool isBakeFile(const std::string& path)
{
    std::array<char, sizeof(Word)> begin{};
    std::ifstream file(path, std::ios::binary);
    return file.read(begin.data(), begin.size()) && begin == magicWord;
}

} // namespace ramure

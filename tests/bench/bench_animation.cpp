// Tracks and the places of nodes.
#include "core/math/random.h"
#include "core/presets/presets.h"
#include "core/rig/tracks/track.h"
#include "core/scene/demo_scenes.h"
#include "core/scene/world_transforms.h"

#include <benchmark/benchmark.h>

namespace ramure {
namespace {

constexpr int keyCount = 100'000;

Track longTrack(KeyMode mode)
{
    Random random(1, RandomStream::Test);
    std::vector<Key> keys(keyCount);
    for (int i = 0; i < keyCount; ++i) {
        keys[std::size_t(i)].time = ticksOf(i * 0.1);
        keys[std::size_t(i)].value = random.range(-1.0, 1.0);
        keys[std::size_t(i)].mode = mode;
    }
    return *Track::fromKeys(std::move(keys));
}

void nextTime(benchmark::State& state)
{
    const Track track = longTrack(static_cast<KeyMode>(state.range(0)));
    TrackCursor cursor;
    double t = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(valueAt(track, t, cursor));
        t = t > 9000.0 ? 0.0 : t + 1.0 / 24.0;
    }
}

void randomTime(benchmark::State& state)
{
    const Track track = longTrack(KeyMode::Bezier);
    Random random(2, RandomStream::Test);
    std::vector<double> times(1 << 16);
    for (double& t : times)
        t = random.range(0.0, keyCount * 0.1);
    std::size_t i = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(valueAt(track, times[i++ & 0xFFFF]));
}

void nextOrientation(benchmark::State& state)
{
    Random random(3, RandomStream::Test);
    std::vector<OrientationKey> keys(1000);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i].time = ticksOf(double(i));
        keys[i].mode = static_cast<KeyMode>(state.range(0));
        keys[i].value = glm::normalize(
            glm::dquat(random.range(0.1, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0), 0.2));
    }
    const auto track = *OrientationTrack::fromKeys(std::move(keys));
    TrackCursor cursor;
    double t = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(valueAt(track, t, cursor));
        t = t > 990.0 ? 0.0 : t + 1.0 / 24.0;
    }
}

void keyEdit(benchmark::State& state)
{
    Track track = longTrack(KeyMode::Bezier);
    Key key;
    for (auto _ : state) {
        key.time = (key.time + 77'777'777'777) % (10'000 * ticksPerSecond);
        key.value = 1.0 - key.value;
        benchmark::DoNotOptimize(track.insert(key));
    }
}

void placesOfMovingTree(benchmark::State& state)
{
    const Scene scene = *demoScene("MovingTree");
    double t = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(worldTransformsAt(scene, t));
        t += 1.0 / 24.0;
    }
}

/// What every thread takes of the document: 10,000 trees.
void copyOfScene(benchmark::State& state)
{
    std::vector<Node> nodes(10'000);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].id = static_cast<NodeId>(i + 1);
        nodes[i].kind = NodeKind::Tree;
        nodes[i].name = "tree";
        nodes[i].params = *presetParams("EnglishOak");
    }
    const Scene scene = *Scene::fromNodes(std::move(nodes));
    for (auto _ : state) {
        const Scene copy = scene;
        benchmark::DoNotOptimize(copy.nodes().size());
    }
}

BENCHMARK(nextTime)
    ->Name("BM_track_next_time")
    ->Arg(int(KeyMode::Linear))
    ->Arg(int(KeyMode::Bezier))
    ->Arg(int(KeyMode::Elastic));
BENCHMARK(randomTime)->Name("BM_track_random_time");
BENCHMARK(nextOrientation)
    ->Name("BM_orientation_next_time")
    ->Arg(int(KeyMode::Linear))
    ->Arg(int(KeyMode::Cubic));
BENCHMARK(keyEdit)->Name("BM_track_edit_100000_keys")->Unit(benchmark::kMillisecond);
BENCHMARK(copyOfScene)->Name("BM_copy_10000_nodes")->Unit(benchmark::kMillisecond);
BENCHMARK(placesOfMovingTree)->Name("BM_places_1365_nodes")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace ramure

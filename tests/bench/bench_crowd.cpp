// Crowds: what is seen of so many places and in which form, for every picture (the promise: 10,000 trees
// within 400 ms a frame, of which this is a small part), and the structure that is made once.
#include "core/math/random.h"
#include "widgets/view/render/crowd/crowd_choice.h"
#include <benchmark/benchmark.h>
#include <cmath>

using namespace ramure;

namespace {

SharedPlaces placesOf(std::int64_t count)
{
    Random random(1, RandomStream::Test);
    const double side = 7.0 * std::sqrt(double(count));
    std::vector<ScatterPlace> places;
    for (std::int64_t i = 0; i < count; ++i)
        places.push_back({{side * random.unit(), 0.0, side * random.unit()},
                          random.range(0.8, 1.2),
                          {1.0, 0.0, 0.0, 0.0},
                          0});
    return std::make_shared<const std::vector<ScatterPlace>>(std::move(places));
}

std::shared_ptr<const Crowd> crowdOf(const SharedPlaces& places)
{
    CrowdPrototype tree;
    tree.box = {glm::dvec3(-3.0, 0.0, -3.0), glm::dvec3(3.0, 15.0, 3.0)};
    for (const auto& [triangles, pixels] :
         {std::pair(20'000, 260.0), {3'000, 110.0}, {500, 44.0}, {6, 0.0}}) {
        tree.forms.emplace_back();
        tree.forms.back().triangles = triangles;
        tree.forms.back().leastPixels = pixels;
    }
    return *Crowd::make(places, {tree});
}

/// \param isWithin the eye stands in the middle and looks along -Z, as a walker does; else all is seen
void choose(benchmark::State& state, bool isWithin)
{
    const auto crowd = crowdOf(placesOf(state.range(0)));
    CrowdSight sight;
    sight.eye = crowd->box().centre();
    sight.pixels = 1000.0;
    for (const glm::dvec3& inwards : {glm::dvec3(1.0, 0.0, -1.5), {-1.0, 0.0, -1.5}})
        if (isWithin)
            sight.planes.emplace_back(inwards, -glm::dot(inwards, sight.eye));
    std::size_t seen = 0;
    for (auto _ : state)
        seen = chooseForms(*crowd, sight, {500'000, 0, 300.0, 1.0}).instances;
    state.counters["seen"] = double(seen);
}
void BM_crowdFromWithin(benchmark::State& state)
{
    choose(state, true);
}
BENCHMARK(BM_crowdFromWithin)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);
void BM_crowdFromAfar(benchmark::State& state)
{
    choose(state, false);
}
BENCHMARK(BM_crowdFromAfar)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

void BM_crowdMake(benchmark::State& state)
{
    const SharedPlaces places = placesOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(crowdOf(places));
}
BENCHMARK(BM_crowdMake)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

} // namespace

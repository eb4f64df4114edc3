// Grammar (per output symbol), turtle (per branch), simplification (per input branch).
#include "tests/bench/bench_trees.h"
#include <benchmark/benchmark.h>

using namespace ramure;

namespace {

const char* const presetNames[] = {"SmallTree", "FanTree", "Fern2D"};
const int presetIterations[] = {12, 11, 7};

bench::Growth growth(const benchmark::State& state)
{
    const auto which = static_cast<std::size_t>(state.range(0));
    return {presetNames[which], presetIterations[which]};
}

void label(benchmark::State& state, std::size_t items)
{
    const auto which = static_cast<std::size_t>(state.range(0));
    state.SetLabel(std::string(presetNames[which]) + " x " + std::to_string(presetIterations[which]));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * items));
}

void BM_grammar(benchmark::State& state)
{
    const bench::Growth tree = growth(state);
    std::size_t size = 0;
    for (auto _ : state) {
        const auto symbols = rewrite(tree.grammar, tree.options);
        size = symbols->size();
        benchmark::DoNotOptimize(symbols->data());
    }
    label(state, size);
}
BENCHMARK(BM_grammar)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

void BM_grammarByChance(benchmark::State& state)
{
    bench::Growth tree = growth(state);
    tree.options.stochastic = true;
    std::size_t size = 0;
    for (auto _ : state) {
        const auto symbols = rewrite(tree.grammar, tree.options);
        size = symbols->size();
        benchmark::DoNotOptimize(symbols->data());
    }
    label(state, size);
}
BENCHMARK(BM_grammarByChance)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);

void BM_turtle(benchmark::State& state)
{
    const bench::Growth tree = growth(state);
    const std::string symbols = tree.symbols();
    std::size_t branches = 0;
    for (auto _ : state) {
        const auto skeleton = runTurtle(symbols, tree.params.turtle);
        branches = skeleton->size();
        benchmark::DoNotOptimize(skeleton->p1.data());
    }
    label(state, branches);
}
BENCHMARK(BM_turtle)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

void BM_simplify(benchmark::State& state)
{
    const Skeleton skeleton = growth(state).skeleton();
    for (auto _ : state) {
        const SimplifiedSkeleton simplified = simplify(skeleton, 1e-4);
        benchmark::DoNotOptimize(simplified.skeleton.p1.data());
    }
    label(state, skeleton.size());
}
BENCHMARK(BM_simplify)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

} // namespace

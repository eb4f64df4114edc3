// All benchmarks run on one thread, as the bars say, or on as many as --threads=N tells (0 = all there are).
#include "core/base/kept_memory.h"
#include "core/base/parallel.h"
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <cstring>
#include <string>

int main(int argc, char** argv)
{
    ramure::keepFreedMemory(); // as both programs do
    unsigned threads = 1;
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        constexpr const char* option = "--threads=";
        if (std::strncmp(argv[i], option, std::strlen(option)) == 0)
            threads = static_cast<unsigned>(std::strtoul(argv[i] + std::strlen(option), nullptr, 10));
        else
            argv[kept++] = argv[i];
    }
    benchmark::Initialize(&kept, argv);
    if (benchmark::ReportUnrecognizedArguments(kept, argv))
        return 2;
    const ramure::ThreadLimit limit(threads);
    benchmark::AddCustomContext("threads", std::to_string(threads));
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

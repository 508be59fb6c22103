#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <time.h>

#include "common/error.hpp"

// What the machine gives at most, measured with as many threads as are asked for: floating-point operations and
// quotients with roots of vectors in registers, and streams from the second-level cache and from memory.

namespace {

/// Processor time of this thread: others on the machine do not lengthen it.
double seconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

template <class Real, int bytes>
struct Packed {
    typedef Real Type __attribute__((vector_size(bytes)));
};

/// `chains` independent chains of multiplications and additions, `rounds` long. The sum keeps them from being left out.
template <class Real, int bytes, int chains>
[[gnu::always_inline]] inline double multiply_and_add(std::int64_t rounds) {
    using Vector = typename Packed<Real, bytes>::Type;
    Vector values[chains];
    for (int i = 0; i < chains; ++i) values[i] = Vector{} + static_cast<Real>(1 + i);
    const Vector factor = Vector{} + static_cast<Real>(0.999), term = Vector{} + static_cast<Real>(1e-3);
    for (std::int64_t k = 0; k < rounds; ++k) {
        for (int i = 0; i < chains; ++i) values[i] = values[i] * factor + term;
    }
    Vector sum = Vector{};
    for (int i = 0; i < chains; ++i) sum += values[i];
    return static_cast<double>(sum[0]);
}

/// The same with one quotient in place of each pair of operations; roots share the unit and take as long or longer.
template <class Real, int bytes, int chains>
[[gnu::always_inline]] inline double divide(std::int64_t rounds) {
    using Vector = typename Packed<Real, bytes>::Type;
    Vector values[chains];
    for (int i = 0; i < chains; ++i) values[i] = Vector{} + static_cast<Real>(1.5 + i);
    const Vector dividend = Vector{} + static_cast<Real>(2);
    for (std::int64_t k = 0; k < rounds; ++k) {
        for (int i = 0; i < chains; ++i) values[i] = dividend / values[i];
    }
    Vector sum = Vector{};
    for (int i = 0; i < chains; ++i) sum += values[i];
    return static_cast<double>(sum[0]);
}

/// One set of vector instructions: the four kernels, and how many values each round of them makes.
struct Instructions {
    const char* name;
    double (*kernels[4])(std::int64_t);
    int values[4];
};

constexpr const char* kernel_names[4] = {"operations_double", "operations_single", "quotients_double",
                                         "quotients_single"};
constexpr int operations_per_value[4] = {2, 2, 1, 1};

#define RECOAT_KERNELS(NAME, TARGET, BYTES, CHAINS)                                                        \
    TARGET double NAME##_fma_double(std::int64_t n) { return multiply_and_add<double, BYTES, CHAINS>(n); } \
    TARGET double NAME##_fma_single(std::int64_t n) { return multiply_and_add<float, BYTES, CHAINS>(n); }  \
    TARGET double NAME##_quotient_double(std::int64_t n) { return divide<double, BYTES, CHAINS>(n); }      \
    TARGET double NAME##_quotient_single(std::int64_t n) { return divide<float, BYTES, CHAINS>(n); }       \
    constexpr Instructions NAME##_instructions = {                                                         \
        #NAME,                                                                                             \
        {NAME##_fma_double, NAME##_fma_single, NAME##_quotient_double, NAME##_quotient_single},            \
        {BYTES / 8 * CHAINS, BYTES / 4 * CHAINS, BYTES / 8 * CHAINS, BYTES / 4 * CHAINS}};

#if defined(__x86_64__)
RECOAT_KERNELS(avx512, [[gnu::target("avx512f")]], 64, 16)
RECOAT_KERNELS(avx2, [[gnu::target("avx2,fma")]], 32, 12)
#endif
RECOAT_KERNELS(baseline, , 16, 12)
#undef RECOAT_KERNELS

const Instructions& best_instructions() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return avx512_instructions;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_instructions;
#endif
    return baseline_instructions;
}

/// Operations per second of this thread: the best of three tries of a fifth of a second and more.
double operations_per_second(const Instructions& instructions, int kernel) {
    double best = 0, kept = 0;
    std::int64_t rounds = 1 << 16;
    for (int tries = 0; tries < 3;) {
        const double start = seconds();
        kept += instructions.kernels[kernel](rounds);
        const double took = seconds() - start;
        if (took < 0.2) {
            rounds *= 2;
            continue;
        }
        const double operations = static_cast<double>(rounds) * instructions.values[kernel];
        best = std::max(best, operations * operations_per_value[kernel] / took);
        ++tries;
    }
    return kept == -1 ? 0 : best;
}

/// a = b + s c over arrays of `count` numbers: bytes per second of this thread, 24 for each number (two read, one
/// written).
double stream_bytes_per_second(std::size_t count) {
    const std::vector<double> b(count, 1.0), c(count, 2.0);
    std::vector<double> a(count, 0.0);
    const auto rounds = std::max<std::size_t>(1, (std::size_t{1} << 25) / count);
    double best = 0;
    for (int tries = 0; tries < 5; ++tries) {
        const double start = seconds();
        for (std::size_t round = 0; round < rounds; ++round) {
            const double scale = 1 + 1e-9 * static_cast<double>(round);
            double* to = a.data();
            const double *from = b.data(), *other = c.data();
            for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + scale * other[i];
            asm volatile("" : : "r"(to) : "memory");
        }
        best = std::max(best, 24.0 * static_cast<double>(count * rounds) / (seconds() - start));
    }
    return best;
}

/// The sum over threads that all measure at the same time.
template <class Function>
double together(int threads, const Function& rate) {
    double sum = 0;
#pragma omp parallel num_threads(threads) reduction(+ : sum)
    {
#pragma omp barrier
        sum += rate();
    }
    return sum;
}

void measure(int threads, std::size_t cached_bytes, std::size_t memory_bytes) {
    const Instructions& instructions = best_instructions();
    std::printf("{\"threads\": %d, \"vectors\": \"%s\"", threads, instructions.name);
    for (int kernel = 0; kernel < 4; ++kernel)
        std::printf(", \"%s_per_second\": %.4g", kernel_names[kernel],
                    together(threads, [&] { return operations_per_second(instructions, kernel); }));
    const std::pair<const char*, std::size_t> streams[] = {{"cached", cached_bytes}, {"memory", memory_bytes}};
    for (const auto& [name, bytes] : streams)
        std::printf(", \"%s_stream_bytes_per_second\": %.4g", name,
                    together(threads, [&, count = bytes / 24] { return stream_bytes_per_second(count); }));
    std::printf("}\n");
}

}  // namespace

/// Peak rates of the machine as one line of JSON.
int main(int argc, char** argv) {
    return recoat::run_program("machine-limits", [&] {
        int threads = 1;
        std::size_t cached = 256, memory = 768;
        CLI::App app("What the machine gives at most");
        app.add_option("--threads", threads, "threads")->check(CLI::PositiveNumber);
        app.add_option("--cached", cached, "KiB of each thread's three arrays that stay in the second-level cache");
        app.add_option("--memory", memory, "MiB of each thread's three arrays that do not stay in any cache");
        CLI11_PARSE(app, argc, argv);
        measure(threads, cached << 10, memory << 20);
        return 0;
    });
}

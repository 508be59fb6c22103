#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "solver/execution/device_array.cuh"

namespace recoat {

/// Captured graphs of some steps each, good as long as no memory of their space has moved.
class CudaGraphs {
public:
    explicit CudaGraphs(Allocations allocations) : allocations_(std::move(allocations)) {}
    CudaGraphs(const CudaGraphs&) = delete;
    CudaGraphs& operator=(const CudaGraphs&) = delete;
    ~CudaGraphs() { clear(); }

    /// The graph of `steps` calls of `body`, which launches kernels on `stream` and does nothing else there.
    template <class Body>
    cudaGraphExec_t of(std::int64_t steps, cudaStream_t stream, const Body& body) {
        if (made_at_ != *allocations_) clear();
        made_at_ = *allocations_;
        cudaGraphExec_t& graph = graphs_[steps];
        if (graph == nullptr) graph = capture(steps, stream, body);
        return graph;
    }

private:
    template <class Body>
    static cudaGraphExec_t capture(std::int64_t steps, cudaStream_t stream, const Body& body) {
        cudaGraph_t recorded = nullptr;
        check_cuda(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "recording steps");
        try {
            for (std::int64_t k = 0; k < steps; ++k) body();
        } catch (...) {
            cudaStreamEndCapture(stream, &recorded);
            if (recorded != nullptr) cudaGraphDestroy(recorded);
            throw;
        }
        check_cuda(cudaStreamEndCapture(stream, &recorded), "recording steps");
        cudaGraphExec_t graph = nullptr;
        const cudaError_t error = cudaGraphInstantiate(&graph, recorded, 0);
        cudaGraphDestroy(recorded);
        check_cuda(error, "preparing recorded steps");
        return graph;
    }

    void clear() {
        for (auto& [steps, graph] : graphs_)
            if (graph != nullptr) cudaGraphExecDestroy(graph);
        graphs_.clear();
    }

    Allocations allocations_;
    std::map<std::int64_t, cudaGraphExec_t> graphs_;
    std::uint64_t made_at_ = 0;
};

}  // namespace recoat

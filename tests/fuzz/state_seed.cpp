/// Writes a small state file, the seed of the bytes of HDF5: state_seed FILE.

#include <fstream>

#include "tests/fuzz/state_mutations.hpp"

int main(int, char** arguments) {
    std::ofstream(arguments[1], std::ios::binary) << recoat::fuzz::small_state_file();
    return 0;
}

#pragma once

#include <vector>

#include "solver/engine/wall.hpp"
#include "solver/scene/stage.hpp"

namespace recoat {

/// Makes one wall of two boxes that together are a box, as long as both stay where they are: over a seam a sphere would
/// touch two walls at once, and lose the history of one contact. Its name is "FIRST and SECOND".
std::vector<Wall> join_boxes(std::vector<Wall> walls, const std::vector<Stage>& stages);

}  // namespace recoat

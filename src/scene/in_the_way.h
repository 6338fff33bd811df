// Still objects in the way of what moves: of blocks, and of figures that patrol. Nothing stops
// there, so a picture shows the one within the other.
#pragma once

namespace slicecast {

struct Reading;

// Adds an aim for each. The scene has been read without faults.
void findThingsInTheWay(Reading& reading);

}  // namespace slicecast

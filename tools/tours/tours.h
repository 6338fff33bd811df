// The tours through the shipped scenes: who gives them, and where they lead. They are kept in
// assets/tours, each under its scene's name.
#pragma once

#include "tours/guide.h"

#include <span>

namespace slicecast {

struct Tour {
    const char* scene;
    void (*give)(Guide& guide);
};

std::span<const Tour> allTours();

}  // namespace slicecast

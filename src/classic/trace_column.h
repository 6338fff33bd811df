// Lists what a column showed and met, as plain data.
#pragma once

#include "classic/column.h"
#include "render/trace.h"

namespace slicecast::classic {

// The trace of the column drawn last, in a picture of this height.
SliceTrace traceOf(const Column& column, const World& world, int pictureHeight, int watchedRow);

}  // namespace slicecast::classic

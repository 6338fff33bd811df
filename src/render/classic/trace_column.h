// What a column showed and met on its way, as plain data.
#pragma once

#include "render/classic/column.h"
#include "render/trace.h"

namespace slicecast::classic {

// Of the column that was drawn last, in a picture of that height.
SliceTrace traceOf(const Column& column, const World& world, int pictureHeight, int watchedRow);

}  // namespace slicecast::classic

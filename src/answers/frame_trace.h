// What drawing a whole picture takes, by the method that draws it.
#pragma once

#include "session/session.h"
#include "slicecast/trace.h"

namespace slicecast {

// The session's view in a picture of this size.
FrameTrace frameTrace(Session& session, int width, int height);

}  // namespace slicecast

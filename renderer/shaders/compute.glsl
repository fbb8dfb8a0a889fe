// One row of invocations (FrameContext::compute).
layout(local_size_x = 64) in;

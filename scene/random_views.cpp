#include "scene/random_views.h"

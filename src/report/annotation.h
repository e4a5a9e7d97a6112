#pragma once

#include "expert/annotation.h"

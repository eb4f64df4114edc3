#include "tests/support/suite.h"

#include "transport/cdr/encapsulation.h"

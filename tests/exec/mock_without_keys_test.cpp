// The same tests where the processor has no protection keys.
#define PINBALL_MOCK_WITHOUT_KEYS
#include "mock_test.cpp"

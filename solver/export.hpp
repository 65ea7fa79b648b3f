#pragma once

#include <pinball/contact/export.h>  // PINBALL_API: the same mark in all libraries

// SPDX-License-Identifier: MIT
#include "penumbra/visibility/c_api_error.h"

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/visibility/c_api_registry.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {
namespace {

/// Of fixed size, so that it can be told that memory is out. Destroyed with the thread, without a
/// destructor: a call may come as late as it likes.
struct LastError {
  penumbra_error code = PENUMBRA_OK;
  char message[1024] = "";
};
thread_local LastError last_error;
thread_local int progress_depth = 0;

penumbra_error keep(penumbra_error code, const char* function, const char* message) {
  last_error.code = code;
  std::snprintf(last_error.message, sizeof last_error.message, "%s: %s", function, message);
  return code;
}

/// Within a catch block.
penumbra_error keep_caught(const char* function) {
  try {
    throw;
  } catch (const ApiError& error) {
    return keep(error.code, function, error.message.c_str());
  } catch (const Error& error) {
    return keep(PENUMBRA_ERROR_INVALID_ARGUMENT, function, error.what());
  } catch (const Cancelled&) {
    return keep(PENUMBRA_ERROR_CANCELLED, function, "cancelled by the progress function");
  } catch (const std::bad_alloc&) {
    return keep(PENUMBRA_ERROR_OUT_OF_MEMORY, function, "out of memory");
  } catch (const std::length_error&) {  // more than a vector can have
    return keep(PENUMBRA_ERROR_OUT_OF_MEMORY, function, "out of memory");
  } catch (const std::exception& error) {
    return keep(PENUMBRA_ERROR_INTERNAL, function, error.what());
  } catch (...) {
    return keep(PENUMBRA_ERROR_INTERNAL, function, "a callback threw");
  }
}

}  // namespace

void refuse_argument(std::string message) {
  throw ApiError{PENUMBRA_ERROR_INVALID_ARGUMENT, std::move(message)};
}

// A question from within another's progress would wait for what waits for it.
void refuse_in_progress() {
  if (progress_depth > 0)
    throw ApiError{PENUMBRA_ERROR_INVALID_OPERATION,
                   "called from within a progress function; do so when the question has ended"};
}

InProgress::InProgress() { ++progress_depth; }
InProgress::~InProgress() { --progress_depth; }

penumbra_error report_caught(const char* function, penumbra_occluders occluders) noexcept {
  const penumbra_error code = keep_caught(function);
  // What it calls may fail in turn: it would be called without end.
  thread_local bool is_telling = false;
  if (is_telling) return code;
  // What the function calls may fail, and take the place of the message.
  const LastError told = last_error;
  is_telling = true;
  try {
    if (const ErrorFunction error = error_function_of(occluders); error.call)
      error.call(error.user, code, told.message);
  } catch (...) {
    // Its exceptions end here: C has nowhere to throw them to, and the error is told already.
  }
  is_telling = false;
  last_error = told;
  return code;
}

}  // namespace penumbra

penumbra_error penumbra_last_error() {
  return std::exchange(penumbra::last_error.code, PENUMBRA_OK);
}

const char* penumbra_last_error_message() { return penumbra::last_error.message; }

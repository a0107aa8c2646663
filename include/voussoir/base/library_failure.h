// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_library_failure_h
#define voussoir_base_library_failure_h

namespace Voussoir
{
/**
 * While this lives, a library that fails in its thread by std::abort(), as in
 * an assertion, or by an invalid address ends the program by a message and with
 * exit status 4, as SolverError does, instead of by a signal. An Interruption
 * sees to that if there is one, and else this class does.
 */
class LibraryFailure
{
public:
  /** @param message is shown behind "voussoir: "; it must outlive this object.
   */
  explicit LibraryFailure(const char *message);
  ~LibraryFailure();
  LibraryFailure(const LibraryFailure &) = delete;
  LibraryFailure &operator=(const LibraryFailure &) = delete;

private:
  const char *const before;
};

/** The message of the LibraryFailure in this thread; null without one. */
const char *message_of_library();

/** The signals of failures have a handler that asks for that message. */
void leave_failures_to_others();
} // namespace Voussoir

#endif

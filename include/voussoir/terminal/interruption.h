// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_terminal_interruption_h
#define voussoir_terminal_interruption_h

#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace Voussoir
{
/**
 * While this lives, SIGINT, SIGTERM and SIGHUP end the program wherever it is,
 * also inside a library, and leave nothing half done.
 *
 * The undo of Uninterrupted::on_interruption() runs, one message on standard
 * error says how the results were left, and the exit status is 128 plus the
 * number of the signal. For main(), before MPI starts; one may live at a time.
 *
 * The handler of the signals only wakes a thread, which waits until no
 * Uninterrupted lives, and does the rest. So nothing else has to look for
 * signals, and nothing that the handler may not do is done in it. The signals
 * are not blocked: there are libraries that start threads before main(), and
 * daemons, which would inherit that. A program started by another one has the
 * handlers of its own.
 *
 * What ends the program without its own doing does so by one message, too, with
 * exit status 4 and the same undo: abort(), as by an assertion of a library, an
 * invalid address, an exception that nobody catches, and exit() by a library,
 * whatever status that names.
 */
class Interruption
{
public:
  /**
   * SIGHUP stays ignored if it is, by nohup; SIGINT does not, although shells
   * without job control let it be ignored in the background.
   *
   * @throws std::system_error if the system has no pipe or thread left.
   */
  Interruption();
  /**
   * From here on the signals are ignored: all is done and said, and they could
   * interrupt only the libraries' way out.
   */
  ~Interruption();
  Interruption(const Interruption &) = delete;
  Interruption &operator=(const Interruption &) = delete;

  /**
   * Handle the signals again, after a library has taken their handlers away:
   * PETSc does, which deal.II starts with MPI. And come before what the library
   * does at exit(): MPI would wait for other processes.
   */
  void listen();

  /**
   * Give no message, and end after the process that does: one speaks for all of
   * a run.
   */
  void be_quiet();

  /** Standard output is a screen, of which the last line is to be cleared. */
  void clear_screen();

  /**
   * All is done, and the program ends with @p status, also if a library fails
   * on its way out, where it may take down threads and files.
   */
  void is_over(int status);

private:
  void watch_failures();

  int read_end;
  std::thread waiting;
};

/**
 * While this lives, no signal ends the program: for what must happen as a whole
 * or not at all, and takes a moment only. One may live at a time in each
 * thread. Without an Interruption, as in a test, it changes nothing.
 */
class Uninterrupted
{
public:
  /** Wait until no other lives, nor an interruption ends the program. */
  Uninterrupted();

  /**
   * Set the action of an interruption from now on, in place of the one before;
   * nothing, if empty. It runs in a thread of its own, when no Uninterrupted
   * lives.
   */
  void on_interruption(std::function<void()> undo);

  /** Set the sentence that follows "Interrupted by ...; " in the message. */
  void state(const std::string &sentence);

private:
  std::lock_guard<std::mutex> lock;
};
} // namespace Voussoir

#endif

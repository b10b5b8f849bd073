#pragma once

#include <httplib.h>

#include <string>

namespace opal {

/// What servers for this machine only have in common.
constexpr const char* kLoopback = "127.0.0.1";

/// Binds a server to a port of 127.0.0.1 that no other program listens on.
/// @param port  0: any free one. @param advice  what to do if it cannot be had, for the message.
/// @return the port. @throws Error if it cannot be had.
int bind_to_loopback(httplib::Server& server, int port, const std::string& advice);

/// Whether a request names this machine and does not come from a web page elsewhere, which may have its own
/// name point here (DNS rebinding).
bool is_from_here(const httplib::Request& request, int port);

/// Headers of a page and of all that it gets: it may run what stands in it and talk to this server, nothing else;
/// nobody may frame it, and nothing is kept.
httplib::Headers page_headers();

/// Tells the runs of a server apart.
std::string run_token();

/// A sentence.
void answer(httplib::Response& response, int status, const std::string& sentence);

}  // namespace opal

#include "actors/components/deployment.hpp"

#include <algorithm>

namespace parlour::actors {

namespace {

bool holds(const std::map<std::string, DeploymentPointer>& all,
           const DeploymentPointer& deployment) {
  const auto found = all.find(deployment->name());
  return found != all.end() && found->second == deployment;
}

} // namespace

std::vector<ServicePointer> Deployment::all() const {
  std::vector<ServicePointer> result;
  for (const auto& [scope, service] : services)
    result.push_back(service);
  return result;
}

DeploymentPointer Deployments::find(const std::string& name) const {
  const auto found = serving.find(name);
  return found == serving.end() ? nullptr : found->second;
}

bool Deployments::is_coming(const DeploymentPointer& deployment) const {
  return holds(coming, deployment);
}

bool Deployments::is_serving(const DeploymentPointer& deployment) const {
  return holds(serving, deployment);
}

std::vector<DeploymentPointer> Deployments::all() const {
  std::vector<DeploymentPointer> result;
  for (const auto* some : {&serving, &coming})
    for (const auto& [name, deployment] : *some)
      result.push_back(deployment);
  return result;
}

// Of equal ranks the one whose name comes first.
std::vector<DeploymentPointer> Deployments::by_rank() const {
  std::vector<DeploymentPointer> result;
  for (const auto& [name, deployment] : serving)
    result.push_back(deployment);
  std::ranges::stable_sort(result, {}, &Deployment::rank);
  return result;
}

} // namespace parlour::actors

# Masters and nodes of this shell talk to this machine only, unless it has been said under which name others know it:
# docs/explanation/security.md.
if [ -z "${ROS_HOSTNAME:-}" ] && [ -z "${ROS_IP:-}" ]; then
  export ROS_HOSTNAME=localhost
fi

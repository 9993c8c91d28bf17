# Masters and nodes of this shell talk to this machine only, unless a name is set under which other machines reach it:
# docs/explanation/security.md.
if [ -z "${ROS_HOSTNAME:-}" ] && [ -z "${ROS_IP:-}" ]; then
  export ROS_HOSTNAME=localhost
fi

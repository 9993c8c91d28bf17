# Masters and nodes of this shell communicate on this machine only, unless ROS_HOSTNAME or ROS_IP is set, by which other
# machines reach it: docs/explanation/security.md.
if [ -z "${ROS_HOSTNAME:-}" ] && [ -z "${ROS_IP:-}" ]; then
  export ROS_HOSTNAME=localhost
fi
